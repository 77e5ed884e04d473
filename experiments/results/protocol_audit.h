// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/datasets/files/table.h"
#include "shapegauge/experiments/evaluation/evaluate_files.h"
#include "shapegauge/experiments/results/evaluation_tables.h"
#include "shapegauge/metrics/method_standings.h"

namespace shapegauge {

/// Score as one evaluator (an evaluation program, metrics/evaluators.h) computes it, for all methods.
struct AuditedScore {
  std::string evaluator;   ///< name of the evaluator; "shapegauge": this library, mean over all orders of ties
  std::string quantity;    ///< common name of the measure, such as "FT"; scores of equal name are compared
  std::string measure;     ///< name of the measure as the evaluator defines it, such as "shrec21.FT"
  Eigen::VectorXd values;  ///< per method: mean score over queries, as a fraction
  std::vector<std::size_t> ranks{};  ///< per method: 1 + the number of methods with a larger score
};

/// Scores of the same methods by all evaluators, to compare evaluation programs.
struct ProtocolAudit {
  std::vector<std::string> methods;  ///< distinct names of the methods
  std::vector<AuditedScore> scores;  ///< scores of all evaluators, those of shapegauge first
  /// For each score of shapegauge, one entry per method: averages over queries with intervals of scores and ranks.
  std::vector<std::vector<MethodStanding>> standings;
  /// Per method: number of queries with relevant and irrelevant models at equal distance.
  std::vector<Eigen::Index> queries_with_ties;
  std::vector<std::string> warnings;  ///< warnings about files and omitted evaluators, one sentence each
};

/// Progress callback: receives the name of the next evaluator and the numbers of completed and of all evaluators.
using AuditProgress = std::function<void(const std::string& file, std::size_t done, std::size_t all)>;

/// Evaluates each matrix (one per method) by all evaluators. `files` are the labels and their interpretation, without
/// the matrix. An evaluator for which no model is a query, such as one that leaves out small classes, is omitted with a
/// warning. Throws InputError as evaluate_files() does.
ProtocolAudit audit_protocols(std::span<const std::filesystem::path> matrices, const EvaluationFiles& files,
                              const StandingOptions& standings, const AuditProgress& progress = {});

/// Returns the quantities, such as "FT", of which the audit has at least two scores, in the order of the audit.
std::vector<std::string> audited_quantities(const ProtocolAudit& audit);

/// Makes a table of one quantity: a row for each method, best first by shapegauge, with the number of queries whose
/// order depends on ties, and the scores and ranks by evaluators that differ from shapegauge. Evaluators with equal
/// scores share a column. Intervals and possible ranks are those of shapegauge.
TextTable audit_table(const ProtocolAudit& audit, const std::string& quantity, const ScoreStyle& style = {});

/// Makes a table with a row for each score that is compared: quantity, evaluator, definition, minimum and maximum
/// of the differences to shapegauge, number of methods with another rank, and Kendall's tau-b of the two rankings.
TextTable audit_summary(const ProtocolAudit& audit, const ScoreStyle& style = {});

/// Makes a table for files with a row for each score and method: quantity, evaluator, definition, method, score, rank,
/// and for shapegauge the interval and the possible ranks; percent.
TextTable audit_csv_table(const ProtocolAudit& audit);

/// Formats the audit as JSON, in fractions.
nlohmann::ordered_json audit_json(const ProtocolAudit& audit);

}  // namespace shapegauge
