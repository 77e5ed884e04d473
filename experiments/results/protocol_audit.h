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

/// A score of one evaluator (metrics/evaluators.h) for all methods.
struct AuditedScore {
  std::string evaluator;   ///< "shapegauge" for the library's own definitions with the mean over all orders of ties
  std::string quantity;    ///< equal for scores that are compared: "FT"
  std::string measure;     ///< its definition: "shrec21.FT"
  Eigen::VectorXd values;  ///< per method: means over queries, fractions
  std::vector<std::size_t> ranks{};  ///< per method: 1 + the number of methods with a larger value
};

/// Scores of the same methods under all evaluators.
struct ProtocolAudit {
  std::vector<std::string> methods;
  std::vector<AuditedScore> scores;  ///< those of shapegauge first
  /// For each score of shapegauge, one entry per method: averages over queries with intervals of scores and ranks.
  std::vector<std::vector<MethodStanding>> standings;
  std::vector<Eigen::Index> queries_with_ties;  ///< by method: of relevant and other models
  std::vector<std::string> warnings;            ///< one sentence each, with the file
};

/// Receives the name of the file that is evaluated next.
using AuditProgress = std::function<void(const std::string& file, std::size_t done, std::size_t all)>;

/// Evaluates each file under all evaluators. `files` are the labels and their interpretation, without the matrix. An
/// evaluator without queries, such as one that leaves out small classes, is omitted with a warning. Throws InputError
/// as evaluate_files() does.
ProtocolAudit audit_protocols(std::span<const std::filesystem::path> matrices, const EvaluationFiles& files,
                              const StandingOptions& standings, const AuditProgress& progress = {});

/// Returns the quantities that several scores of the audit measure, in their order.
std::vector<std::string> audited_quantities(const ProtocolAudit& audit);

/// Makes a table of one quantity: a row for each method, best first by shapegauge, with the number of queries whose
/// order depends on ties, and the scores and ranks of the evaluators that differ. Those with equal scores share a
/// column. Intervals and possible ranks are those of shapegauge.
TextTable audit_table(const ProtocolAudit& audit, const std::string& quantity, const ScoreStyle& style = {});

/// Makes a table with a row for each score that is compared: quantity, evaluator, definition, minimum and maximum
/// of the differences to shapegauge, number of methods with another rank, and Kendall's tau-b of the two rankings.
TextTable audit_summary(const ProtocolAudit& audit, const ScoreStyle& style = {});

/// Makes a table for files: quantity, evaluator, definition, method, score, rank, and for shapegauge the interval and
/// the possible ranks; percent.
TextTable audit_csv_table(const ProtocolAudit& audit);

/// Formats the audit as JSON, in fractions.
nlohmann::ordered_json audit_json(const ProtocolAudit& audit);

}  // namespace shapegauge
