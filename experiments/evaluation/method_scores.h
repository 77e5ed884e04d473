// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/experiments/evaluation/evaluate_files.h"
#include "shapegauge/metrics/evaluation.h"

namespace shapegauge {

/// Scores of one method for every query.
struct MethodScores {
  std::string method;
  std::string source;  ///< file of the scores
  std::string protocol;
  std::vector<std::string> measures;
  std::vector<std::string> queries{};  ///< ids
  std::vector<std::string> classes{};  ///< classes of the queries
  Eigen::MatrixXd values{};            ///< queries x measures, fractions
};

/// File of a run's results that has the scores of all methods for every query.
inline constexpr std::string_view per_query_name = "per_query.csv";

/// Reads the scores of all methods in a table of `run` or `evaluate --per-query`: method,protocol,id,class and then
/// measures in percent. Throws InputError for another header, a row of another length, a cell that is not a number from
/// 0 to 100, and a repeated query of a method and protocol.
std::vector<MethodScores> read_method_scores(const std::filesystem::path& path);

/// Returns the name of a method: the tag of a TREC run, otherwise the file's name without its extension.
std::string method_name(const std::filesystem::path& path, const EvaluationData& data);

/// Returns the scores of an evaluation.
MethodScores method_scores(const std::string& method, const std::string& source, const EvaluationTask& task,
                           const Evaluation& evaluation);

/// Numbers the classes of queries in the order of their first appearance.
std::vector<int> class_numbers(const std::vector<std::string>& classes);

/// Methods aligned to the same queries.
struct AlignedMethods {
  std::vector<std::string> methods;
  std::string protocol;
  std::vector<std::string> measures;
  std::vector<int> classes;               ///< class of each query
  std::vector<Eigen::MatrixXd> values{};  ///< per measure: queries x methods
};

/// Aligns methods to the same queries and measures: the requested measures, or all common ones. `names` are the
/// methods' names, if given. Otherwise methods of equal names get the shortest distinguishing suffix of their file's
/// path. There must be at least one method. Throws InputError for different protocols, queries that differ between
/// methods or have different classes, a missing measure, a wrong number of names, and equal names.
AlignedMethods align_methods(std::span<const MethodScores> methods, std::span<const std::string> wanted_measures,
                             std::span<const std::string> names = {});

}  // namespace shapegauge
