// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/metrics/retrieval_task.h"

#include <algorithm>
#include <numeric>

namespace shapegauge {

RetrievalTask leave_one_out(std::span<const int> labels) {
  RetrievalTask task;
  task.query_classes.assign(labels.begin(), labels.end());
  task.target_classes = task.query_classes;
  task.own_column.resize(labels.size());
  std::iota(task.own_column.begin(), task.own_column.end(), Eigen::Index{0});
  return task;
}

int subclass_grade(int query, int model) {
  if (query == model) return 3;
  return model == no_subclass ? 2 : 1;
}

std::vector<int> number_subclasses(std::span<const std::string> names) {
  std::unordered_map<std::string, int> known;
  std::vector<int> numbers;
  numbers.reserve(names.size());
  for (const std::string& name : names) {
    const int next = static_cast<int>(known.size());
    numbers.push_back(name.empty() ? no_subclass : known.emplace(name, next).first->second);
  }
  if (known.empty()) numbers.clear();
  return numbers;
}

bool has_grades(const RetrievalTask& task) { return !task.grades.empty() || !task.query_subclasses.empty(); }

std::vector<std::size_t> relevant_counts(const RetrievalTask& task) {
  std::unordered_map<int, std::size_t> targets_of_class;
  for (const int target : task.target_classes) ++targets_of_class[target];
  std::vector<std::size_t> counts;
  for (std::size_t row = 0; row < task.query_classes.size(); ++row) {
    const int query_class = task.query_classes[row];
    const Eigen::Index query_column = task.own_column[row];
    if (query_class == no_class) {
      counts.push_back(0);
      continue;
    }
    const bool counts_itself =
        query_column >= 0 &&
        (task.judged.empty() ? task.target_classes[static_cast<std::size_t>(query_column)] == query_class
                             : std::ranges::binary_search(task.judged[row], query_column));
    const std::size_t all = task.judged.empty() ? targets_of_class[query_class] : task.judged[row].size();
    counts.push_back(all - (counts_itself ? 1 : 0));
  }
  return counts;
}

Relevance::Relevance(const RetrievalTask& task) : task_(&task), relevant_(relevant_counts(task)) {
  for (std::size_t column = 0; column < task.target_classes.size(); ++column) {
    if (task.target_classes[column] == no_class) continue;
    ++targets_;
    if (task.query_subclasses.empty()) continue;
    columns_of_class_[task.target_classes[column]].push_back(static_cast<Eigen::Index>(column));
  }
}

bool Relevance::is_relevant(Eigen::Index row, Eigen::Index column) const {
  const auto i = static_cast<std::size_t>(row);
  if (!task_->judged.empty()) return std::ranges::binary_search(task_->judged[i], column);
  return task_->target_classes[static_cast<std::size_t>(column)] == task_->query_classes[i];
}

bool Relevance::is_judged_irrelevant(Eigen::Index row, Eigen::Index column) const {
  return task_->judged_irrelevant.empty() ||
         std::ranges::binary_search(task_->judged_irrelevant[static_cast<std::size_t>(row)], column);
}

double Relevance::grade(Eigen::Index row, Eigen::Index column) const {
  const auto i = static_cast<std::size_t>(row);
  if (!task_->query_subclasses.empty()) {
    return subclass_grade(task_->query_subclasses[i], task_->target_subclasses[static_cast<std::size_t>(column)]);
  }
  if (task_->grades.empty()) return 1;
  const std::vector<Eigen::Index>& judged = task_->judged[i];
  return task_->grades[i][static_cast<std::size_t>(std::ranges::lower_bound(judged, column) - judged.begin())];
}

std::size_t Relevance::judged_irrelevant(Eigen::Index row) const {
  const auto i = static_cast<std::size_t>(row);
  const Eigen::Index query_column = task_->own_column[i];
  if (!task_->judged_irrelevant.empty()) {
    const std::vector<Eigen::Index>& judged = task_->judged_irrelevant[i];
    return judged.size() - (std::ranges::binary_search(judged, query_column) ? 1 : 0);
  }
  const bool query_is_target =
      query_column >= 0 && task_->target_classes[static_cast<std::size_t>(query_column)] != no_class;
  return targets_ - relevant(row) - (query_is_target ? 1 : 0);
}

std::vector<double> Relevance::grades(Eigen::Index row) const {
  if (!has_grades(*task_)) return {};
  const auto i = static_cast<std::size_t>(row);
  const std::vector<Eigen::Index>* columns = nullptr;
  if (!task_->judged.empty()) {
    columns = &task_->judged[i];
  } else if (const auto found = columns_of_class_.find(task_->query_classes[i]); found != columns_of_class_.end()) {
    columns = &found->second;
  }
  std::vector<double> grades;
  if (columns == nullptr) return grades;
  for (const Eigen::Index column : *columns) {
    if (column != task_->own_column[i]) grades.push_back(grade(row, column));
  }
  return grades;
}

}  // namespace shapegauge
