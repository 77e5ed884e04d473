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

/// Returns warnings about a matrix, one sentence each. `ids` name its rows; `negated` means that it contained
/// similarities.
std::vector<std::string> matrix_warnings(const MatrixFindings& found, std::span<const std::string> ids, bool negated);

/// Returns warnings about a matrix to be re-ranked, one sentence each. Reads it once more.
std::vector<std::string> rerank_warnings(const OpenMatrix& matrix);

/// Returns the warning about queries with relevant and other models at equal distance, with the effect of their order
/// on FT. Nothing if all these queries are rows of equal distances, which matrix_warnings() reports.
std::optional<std::string> ties_warning(const Evaluation& evaluation, const MatrixFindings& found);

/// Returns the warning about fewer relevant nearest neighbours than a random order has, which rows in the wrong order
/// or similarities read as distances may cause. For matrices only: lists may lack models.
std::optional<std::string> chance_warning(const Evaluation& evaluation, const MatrixFindings& found,
                                          const RetrievalTask& task);

/// Returns the warning about models that are never queries because their classes are small, if there are any.
std::optional<std::string> left_out_warning(const Evaluation& evaluation, const RetrievalTask& task,
                                            const EvaluationOptions& options);

}  // namespace shapegauge
