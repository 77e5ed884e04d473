// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/datasets/files/open_matrix.h"
#include "shapegauge/metrics/evaluation.h"
#include "shapegauge/metrics/matrix_checks.h"

namespace shapegauge {

/// Returns warnings about anomalies found in a distance matrix, one sentence each. `ids` has the model id of each row.
/// `negated` means that the file had similarities, whose signs were changed.
std::vector<std::string> matrix_warnings(const MatrixFindings& found, std::span<const std::string> ids, bool negated);

/// Returns warnings about a distance matrix that is to be re-ranked, one sentence each: similarities instead of
/// distances, asymmetry. Reads the whole matrix.
std::vector<std::string> rerank_warnings(const OpenMatrix& matrix);

/// Returns a warning about queries with relevant and irrelevant models at equal distance, with the effect of the order
/// of ties on the first tier (FT). Returns nothing if all such queries have constant rows, which matrix_warnings()
/// reports.
std::optional<std::string> ties_warning(const Evaluation& evaluation, const MatrixFindings& found);

/// Returns a warning if far fewer nearest neighbours are relevant than in a random order, as with rows in the wrong
/// order or similarities read as distances; otherwise nothing. For matrices only: ranked lists may lack models.
std::optional<std::string> chance_warning(const Evaluation& evaluation, const MatrixFindings& found,
                                          const RetrievalTask& task);

/// Returns a warning about models that are never queries because their classes are small; nothing if there are none.
std::optional<std::string> left_out_warning(const Evaluation& evaluation, const RetrievalTask& task,
                                            const EvaluationOptions& options);

}  // namespace shapegauge
