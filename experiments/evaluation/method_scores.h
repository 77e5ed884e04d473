#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/experiments/evaluation/evaluate_files.h"
#include "shapegauge/metrics/evaluation.h"

namespace shapegauge {

/// What one method gives for every query.
struct MethodScores {
  std::string method;
  std::string source;  ///< file that it is from
  std::string protocol;
  std::vector<std::string> measures;
  std::vector<std::string> queries;  ///< ids
  std::vector<std::string> classes;  ///< of the queries
  Eigen::MatrixXd values;            ///< queries x measures, fractions
};

/// The values of all methods in a table as `run` and `evaluate --per-query` write it: method,protocol,id,class and then
/// measures in percent. Throws InputError: another header, a row of another length, a cell that is no number from 0 to
/// 100, a query that occurs twice for a method and protocol.
std::vector<MethodScores> read_method_scores(const std::filesystem::path& path);

/// The name of a method by its file: that which a TREC run gives itself, else the file's without its extension.
std::string method_name(const std::filesystem::path& path, const EvaluationData& data);

/// The values of an evaluation.
MethodScores method_scores(const std::string& method, const std::string& source, const EvaluationTask& task,
                           const Evaluation& evaluation);

/// Methods side by side on the same queries.
struct AlignedMethods {
  std::vector<std::string> methods;
  std::string protocol;
  std::vector<std::string> measures;
  std::vector<int> classes;             ///< of each query
  std::vector<Eigen::MatrixXd> values;  ///< by measure: queries x methods
};

/// Brings methods to the same queries and measures: those that are wanted, or all that every method has. `names`, if
/// there are any, name the methods; otherwise methods of equal name get the shortest end of their file's path that
/// tells them apart. Throws InputError: fewer than two methods, different protocols, a query that one method has and
/// another has not, or has in another class, a measure that a method does not have, another number of names, equal
/// names.
AlignedMethods align_methods(std::span<const MethodScores> methods, std::span<const std::string> wanted_measures,
                             std::span<const std::string> names = {});

}  // namespace shapegauge
