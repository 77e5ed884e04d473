#include "shapegauge/metrics/retrieval_task.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace shapegauge {

RetrievalTask leave_one_out(std::span<const int> labels) {
  RetrievalTask task;
  task.query_classes.assign(labels.begin(), labels.end());
  task.target_classes = task.query_classes;
  task.own_column.resize(labels.size());
  std::iota(task.own_column.begin(), task.own_column.end(), Eigen::Index{0});
  return task;
}

bool is_relevant(const RetrievalTask& task, Eigen::Index row, Eigen::Index column) {
  const auto i = static_cast<std::size_t>(row);
  if (!task.judged.empty()) return std::ranges::binary_search(task.judged[i], column);
  return task.target_classes[static_cast<std::size_t>(column)] == task.query_classes[i];
}

int subclass_grade(int query, int model) {
  if (query == model) return 3;
  return model == no_subclass ? 2 : 1;
}

std::vector<int> numbered_subclasses(std::span<const std::string> names) {
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

double grade_of(const RetrievalTask& task, Eigen::Index row, Eigen::Index column) {
  const auto i = static_cast<std::size_t>(row);
  if (!task.query_subclasses.empty()) {
    return subclass_grade(task.query_subclasses[i], task.target_subclasses[static_cast<std::size_t>(column)]);
  }
  if (task.grades.empty()) return 1;
  const std::vector<Eigen::Index>& judged = task.judged[i];
  return task.grades[i][static_cast<std::size_t>(std::ranges::lower_bound(judged, column) - judged.begin())];
}

std::vector<std::size_t> relevant_counts(const RetrievalTask& task) {
  std::unordered_map<int, std::size_t> targets_of_class;
  for (const int target : task.target_classes) ++targets_of_class[target];
  std::vector<std::size_t> counts;
  for (std::size_t row = 0; row < task.query_classes.size(); ++row) {
    const int query_class = task.query_classes[row];
    const Eigen::Index own = task.own_column[row];
    if (query_class == no_class) {
      counts.push_back(0);
      continue;
    }
    const std::size_t all = task.judged.empty() ? targets_of_class[query_class] : task.judged[row].size();
    const bool counts_itself = own >= 0 && is_relevant(task, static_cast<Eigen::Index>(row), own);
    counts.push_back(all - (counts_itself ? 1 : 0));
  }
  return counts;
}

}  // namespace shapegauge
