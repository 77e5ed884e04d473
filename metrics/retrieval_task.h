#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace shapegauge {

/// Distances, row-major: entry (i, j) is the distance from query i to model j.
using DistanceMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
/// A matrix of distances that is someone else's.
using DistanceTable = Eigen::Ref<const DistanceMatrix>;

/// The class of a row that is no query, or of a column that is not to be found.
inline constexpr int no_class = std::numeric_limits<int>::min();

/// What the rows and columns of a distance matrix mean: which rows are queries, which columns are the models to be
/// found (the targets), and which of them are relevant to which query.
struct RetrievalTask {
  std::vector<int> query_classes;   ///< by row; no_class: the row is no query
  std::vector<int> target_classes;  ///< by column; no_class: the column is no target
  /// By row the column that is the query itself, which is never part of its own answer; -1: none.
  std::vector<Eigen::Index> own_column;
  /// By row the columns that are relevant, ascending. Empty: the targets of the query's class are.
  std::vector<std::vector<Eigen::Index>> judged;
  /// By row the grades, above 0, of the judged columns. Empty: all are 1. Only measures that say so look at them.
  std::vector<std::vector<int>> grades;
  /// By row the columns that are judged and not relevant, ascending. Empty: all that are not relevant.
  std::vector<std::vector<Eigen::Index>> judged_irrelevant;
  /// A distance that is NaN says that the query's answer does not have the model at all (a list that was cut off).
  bool lists_may_end_early = false;
};

/// Every model is a query to all others. labels[i] is the class of model i.
RetrievalTask leave_one_out(std::span<const int> labels);

/// Whether the target in the column is relevant to the query in the row.
bool is_relevant(const RetrievalTask& task, Eigen::Index row, Eigen::Index column);

/// By row the number of relevant targets, the query itself left out; 0 for rows that are no queries.
std::vector<std::size_t> relevant_counts(const RetrievalTask& task);

}  // namespace shapegauge
