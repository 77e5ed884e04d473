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

/// Scores of one method under one protocol, for every query.
struct MethodScores {
  std::string method;                  ///< name of the method
  std::string source;                  ///< path of the file that the scores are from
  std::string protocol;                ///< name of the evaluation protocol
  std::vector<std::string> measures;   ///< names of the measures, such as "FT"
  std::vector<std::string> queries{};  ///< ids of the queries
  std::vector<std::string> classes{};  ///< class name of each query
  Eigen::MatrixXd values{};            ///< scores as fractions, from 0 to 1: one row per query, one column per measure
};

/// Name of the file in the results of a run that has the scores of all methods for every query.
inline constexpr std::string_view per_query_name = "per_query.csv";

/// Reads the scores of all methods from a table that `run` or `evaluate --per-query` has written: columns method,
/// protocol, id, class and then the measures in percent. Throws InputError for another header, a row of another length,
/// a score that is not a number or out of range, and a repeated query of a method and protocol.
std::vector<MethodScores> read_method_scores(const std::filesystem::path& path);

/// Returns the name of the method whose results a file has: the tag of a TREC run, otherwise the file's name without
/// its extension.
std::string method_name(const std::filesystem::path& path, const EvaluationData& data);

/// Converts an evaluation to the scores of its method, with ids and class names from the task. `source` is the path of
/// the evaluated file.
MethodScores method_scores(const std::string& method, const std::string& source, const EvaluationTask& task,
                           const Evaluation& evaluation);

/// Returns the class index of each query. Classes have the indices 0, 1, ... in the order of their first appearance.
std::vector<int> class_numbers(const std::vector<std::string>& classes);

/// Scores of several methods for the same queries, in the same order.
struct AlignedMethods {
  std::vector<std::string> methods;       ///< distinct names of the methods
  std::string protocol;                   ///< name of the evaluation protocol of all methods
  std::vector<std::string> measures;      ///< names of the measures, such as "FT"
  std::vector<int> classes;               ///< class index of each query
  std::vector<Eigen::MatrixXd> values{};  ///< per measure: scores as fractions, a row per query, a column per method
};

/// Aligns the scores of methods by query, for the requested measures, or for all common measures if
/// `requested_measures` is empty. `names` are the methods' names, if not empty. Otherwise methods of equal names get
/// the shortest distinguishing suffix of their file's path. There must be at least one method. Throws InputError for
/// different protocols, queries that differ between methods or have different classes, a missing measure, a wrong
/// number of names, and equal names.
AlignedMethods align_methods(std::span<const MethodScores> methods, std::span<const std::string> requested_measures,
                             std::span<const std::string> names = {});

}  // namespace shapegauge
