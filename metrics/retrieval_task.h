// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "shapegauge/core/base/distance_rows.h"

namespace shapegauge {

/// Class of a row that is not a query, or of a column that is not a target.
inline constexpr int no_class = std::numeric_limits<int>::min();

/// Subclass of a model that belongs to its class as such, not to one of the subclasses.
inline constexpr int no_subclass = -1;

/// Interpretation of a distance matrix: which rows are queries, which columns are the models to be retrieved (the
/// targets), and which targets are relevant to which query.
struct RetrievalTask {
  std::vector<int> query_classes;   ///< per row; no_class if the row is not a query
  std::vector<int> target_classes;  ///< per column; no_class if the column is not a target
  /// By row: the column of the query itself, which is excluded from its answer; -1 if there is none.
  std::vector<Eigen::Index> own_column;
  /// By row: the relevant columns, ascending. If empty, the targets of the query's class are relevant.
  std::vector<std::vector<Eigen::Index>> judged;
  /// By row: positive grades of the relevant columns. All 1 if empty. Only used by graded measures.
  std::vector<std::vector<int>> grades;
  /// Subclasses of the rows and of the columns, which grade relevant columns by subclass_grade() unless there are
  /// judgements. If both are empty, all grades are 1.
  std::vector<int> query_subclasses{};
  std::vector<int> target_subclasses{};
  /// By row: the columns judged as not relevant, ascending. If empty, all that are not relevant.
  std::vector<std::vector<Eigen::Index>> judged_irrelevant;
};

/// Makes a task with every model as a query to all others. labels[i] is the class of model i.
RetrievalTask leave_one_out(std::span<const int> labels);

/// Returns the grade of a model of the query's class: 3 in the same subclass, 2 if the model has none, 1 in another
/// subclass. Source: Savva and others, Large-scale 3D shape retrieval from ShapeNet Core55, Eurographics Workshop on 3D
/// Object Retrieval 2016, where a model without a subclass has its class's name as one.
int subclass_grade(int query, int model);

/// Numbers subclasses by name: equal names have equal numbers, an empty name is no_subclass. Empty if all names are.
std::vector<int> number_subclasses(std::span<const std::string> names);

/// Returns true if relevant targets may have grades other than 1.
bool has_grades(const RetrievalTask& task);

/// Returns per row the number of relevant targets without the query itself; 0 for rows that are not queries.
std::vector<std::size_t> relevant_counts(const RetrievalTask& task);

/// Relevance of targets to queries, with the numbers of relevant and other targets known in advance: a list need not
/// have them all. The task must outlive the object.
class Relevance {
 public:
  explicit Relevance(const RetrievalTask& task);

  [[nodiscard]] const RetrievalTask& task() const { return *task_; }

  /// Returns true if the column is a target and not the query itself.
  [[nodiscard]] bool is_target(Eigen::Index row, Eigen::Index column) const {
    return task_->target_classes[static_cast<std::size_t>(column)] != no_class &&
           task_->own_column[static_cast<std::size_t>(row)] != column;
  }
  /// Returns true if the target in the column is relevant to the query in the row.
  [[nodiscard]] bool is_relevant(Eigen::Index row, Eigen::Index column) const;
  /// Returns true if the target is judged as not relevant; false if it was not judged.
  [[nodiscard]] bool is_judged_irrelevant(Eigen::Index row, Eigen::Index column) const;
  /// Returns the grade of a relevant column.
  [[nodiscard]] double grade(Eigen::Index row, Eigen::Index column) const;

  /// Number of relevant targets.
  [[nodiscard]] std::size_t relevant(Eigen::Index row) const { return relevant_[static_cast<std::size_t>(row)]; }
  /// Number of targets judged as not relevant.
  [[nodiscard]] std::size_t judged_irrelevant(Eigen::Index row) const;
  /// Grades of all relevant targets; empty if all are 1.
  [[nodiscard]] std::vector<double> grades(Eigen::Index row) const;

 private:
  const RetrievalTask* task_;
  std::vector<std::size_t> relevant_;  // per row
  std::size_t targets_ = 0;
  std::unordered_map<int, std::vector<Eigen::Index>> columns_of_class_;  // with subclasses
};

}  // namespace shapegauge
