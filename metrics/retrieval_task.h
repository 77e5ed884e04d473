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

/// Class of a matrix row that is not a query, or of a matrix column that is not a target.
inline constexpr int no_class = std::numeric_limits<int>::min();

/// Subclass of a model that belongs to a class, but to none of its subclasses.
inline constexpr int no_subclass = -1;

/// Interpretation of a distance matrix: which rows are queries, which columns are the models to be retrieved (the
/// targets), and which targets are relevant to which query.
struct RetrievalTask {
  std::vector<int> query_classes;   ///< class of each row; no_class if the row is not a query
  std::vector<int> target_classes;  ///< class of each column; no_class if the column is not a target
  /// Per row: the column of the same model, which is excluded from the list of the query; -1 if there is none.
  std::vector<Eigen::Index> own_column;
  /// Per row: the columns that are judged relevant, ascending. If `judged` is empty, the targets of the class of the
  /// query are relevant.
  std::vector<std::vector<Eigen::Index>> judged;
  /// Per row: positive relevance grades of the columns in `judged`. If `grades` is empty, all grades are 1. Only used
  /// by graded measures.
  std::vector<std::vector<int>> grades;
  /// Subclass of each row, no_subclass for none. If the list is not empty, relevant columns have the grade
  /// subclass_grade() of row and column.
  std::vector<int> query_subclasses{};
  std::vector<int> target_subclasses{};  ///< subclass of each column; empty if query_subclasses is empty
  /// Per row: the columns that are judged as not relevant, ascending. If `judged_irrelevant` is empty, all targets that
  /// are not relevant.
  std::vector<std::vector<Eigen::Index>> judged_irrelevant;
};

/// Makes a task with every model as a query to all others. labels[i] is the class of model i.
RetrievalTask leave_one_out(std::span<const int> labels);

/// Returns the grade of a model of the class of the query, from the subclasses of query and model: 3 if they are equal,
/// 2 if the model has none, 1 if they differ. Source: Savva and others, Large-scale 3D shape retrieval from ShapeNet
/// Core55, Eurographics Workshop on 3D Object Retrieval 2016, where a model without a subclass has the name of its
/// class as one.
int subclass_grade(int query, int model);

/// Returns a number for each subclass name: equal for equal names, no_subclass for an empty name. Returns an empty
/// vector if all names are empty.
std::vector<int> number_subclasses(std::span<const std::string> names);

/// Returns true if relevant targets may have grades other than 1.
bool has_grades(const RetrievalTask& task);

/// Returns the number of relevant targets of each row, without the query itself; 0 for rows that are not queries.
std::vector<std::size_t> relevant_counts(const RetrievalTask& task);

/// Relevance of the targets of a RetrievalTask to its queries. Counts all targets, also those that a ranked list lacks.
/// The task must outlive the object.
class Relevance {
 public:
  explicit Relevance(const RetrievalTask& task);  ///< counts the relevant targets of each row

  /// Returns the task of the constructor.
  [[nodiscard]] const RetrievalTask& task() const { return *task_; }

  /// Returns true if the column is a target and not the query in the row itself.
  [[nodiscard]] bool is_target(Eigen::Index row, Eigen::Index column) const {
    return task_->target_classes[static_cast<std::size_t>(column)] != no_class &&
           task_->own_column[static_cast<std::size_t>(row)] != column;
  }
  /// Returns true if the target in the column is relevant to the query in the row.
  [[nodiscard]] bool is_relevant(Eigen::Index row, Eigen::Index column) const;
  /// Returns true if a target that is not relevant to the query is judged so; always true if the task has no
  /// judged_irrelevant.
  [[nodiscard]] bool is_judged_irrelevant(Eigen::Index row, Eigen::Index column) const;
  /// Returns the grade of the relevant target in the column for the query in the row; 1 if the task has no grades.
  [[nodiscard]] double grade(Eigen::Index row, Eigen::Index column) const;

  /// Returns the number of targets that are relevant to the query in the row, without the query itself.
  [[nodiscard]] std::size_t relevant(Eigen::Index row) const { return relevant_[static_cast<std::size_t>(row)]; }
  /// Returns the number of targets that are judged as not relevant to the query in the row.
  [[nodiscard]] std::size_t judged_irrelevant(Eigen::Index row) const;
  /// Returns the grades of all targets relevant to the query in the row; empty if the task has no grades.
  [[nodiscard]] std::vector<double> grades(Eigen::Index row) const;

 private:
  const RetrievalTask* task_;                                            // task of the constructor, never null
  std::vector<std::size_t> relevant_;                                    // number of relevant targets per row
  std::size_t targets_ = 0;                                              // number of columns that are targets
  std::unordered_map<int, std::vector<Eigen::Index>> columns_of_class_;  // target columns per class, with subclasses
};

}  // namespace shapegauge
