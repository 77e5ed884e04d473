#include "shapegauge/metrics/evaluation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <tbb/parallel_for.h>
#include <utility>

#include "shapegauge/metrics/ranked_list.h"

namespace shapegauge {
namespace {

void check_square(const DistanceTable& distances, std::span<const int> labels) {
  if (distances.rows() != distances.cols()) {
    throw std::invalid_argument("a distance matrix must be square, not " + std::to_string(distances.rows()) + " x " +
                                std::to_string(distances.cols()));
  }
  if (static_cast<std::size_t>(distances.rows()) != labels.size()) {
    throw std::invalid_argument("the distance matrix is for " + std::to_string(distances.rows()) + " models, but " +
                                std::to_string(labels.size()) + " have a class");
  }
}

void check_task(const DistanceTable& distances, const RetrievalTask& task, const EvaluationOptions& options) {
  const auto rows = static_cast<std::size_t>(distances.rows());
  const auto columns = static_cast<std::size_t>(distances.cols());
  const bool fits = task.query_classes.size() == rows && task.own_column.size() == rows &&
                    task.target_classes.size() == columns && (task.judged.empty() || task.judged.size() == rows);
  if (!fits) {
    throw std::invalid_argument("the retrieval task is for " + std::to_string(task.query_classes.size()) +
                                " queries and " + std::to_string(task.target_classes.size()) +
                                " targets, the distance matrix is " + std::to_string(rows) + " x " +
                                std::to_string(columns));
  }
  if (options.minimum_class_size < 2) {
    throw std::invalid_argument("the minimum class size must be at least 2, not " +
                                std::to_string(options.minimum_class_size) +
                                ": a class of one model has no relevant answer");
  }
}

void check_numbers(const DistanceTable& distances) {
  for (Eigen::Index row = 0; row < distances.rows(); ++row) {
    for (Eigen::Index column = 0; column < distances.cols(); ++column) {
      if (!std::isnan(distances(row, column))) continue;
      throw std::invalid_argument("the distance in row " + std::to_string(row) + ", column " + std::to_string(column) +
                                  " (counted from 0) is not a number");
    }
  }
}

// The rows that are queries, and the classes that have queries.
void choose_queries(const RetrievalTask& task, int minimum_class_size, Evaluation& evaluation) {
  const std::vector<std::size_t> relevant = relevant_counts(task);
  const auto minimum = static_cast<std::size_t>(minimum_class_size);
  std::set<int> classes;
  for (std::size_t row = 0; row < relevant.size(); ++row) {
    if (task.query_classes[row] == no_class) continue;
    if (relevant[row] + 1 < minimum) {
      ++evaluation.models_left_out;
      continue;
    }
    evaluation.queries.push_back(static_cast<Eigen::Index>(row));
    evaluation.query_classes.push_back(task.query_classes[row]);
    classes.insert(task.query_classes[row]);
  }
  if (classes.empty()) {
    throw std::invalid_argument("no class has " + std::to_string(minimum) + " models or more, so there are no queries");
  }
  evaluation.classes.assign(classes.begin(), classes.end());
}

// Mean of the rows in each group, in the order of the rows. Every group has rows.
Eigen::MatrixXd mean_by_group(const Eigen::MatrixXd& table, const std::vector<std::vector<Eigen::Index>>& groups) {
  Eigen::MatrixXd means = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(groups.size()), table.cols());
  for (std::size_t group = 0; group < groups.size(); ++group) {
    const auto row = static_cast<Eigen::Index>(group);
    for (const Eigen::Index member : groups[group]) means.row(row) += table.row(member);
    means.row(row) /= static_cast<double>(groups[group].size());
  }
  return means;
}

Eigen::VectorXd mean_of_rows(const Eigen::MatrixXd& table) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(table.cols());
  for (Eigen::Index row = 0; row < table.rows(); ++row) sum += table.row(row).transpose();
  return sum / static_cast<double>(table.rows());
}

struct QueryResults {
  Eigen::MatrixXd measures;           // queries x measures
  Eigen::MatrixXd precisions;         // queries x recall levels
  std::vector<std::size_t> relevant;  // of each query
  std::vector<char> tied;             // of each query; no vector<bool>, whose neighbours two threads cannot write
};

QueryResults judge_queries(const DistanceTable& distances, const RetrievalTask& task, std::span<const Measure> measures,
                           const Evaluation& evaluation) {
  const auto count = static_cast<Eigen::Index>(evaluation.queries.size());
  const bool paper = evaluation.protocol == Protocol::paper;
  const std::vector<std::size_t> relevant = relevant_counts(task);
  const std::size_t largest = *std::ranges::max_element(relevant) + (paper ? 1 : 0);
  QueryResults results;
  results.measures.resize(count, static_cast<Eigen::Index>(measures.size()));
  results.precisions.resize(count, static_cast<Eigen::Index>(recall_levels(evaluation.curve, largest).size()));
  results.relevant.resize(evaluation.queries.size());
  results.tied.resize(evaluation.queries.size());
  tbb::parallel_for(std::size_t{0}, evaluation.queries.size(), [&](std::size_t i) {
    const auto row = static_cast<Eigen::Index>(i);
    const RankedList list = ranked_list(distances, task, evaluation.queries[i], evaluation.protocol, evaluation.ties);
    for (std::size_t j = 0; j < measures.size(); ++j) {
      results.measures(row, static_cast<Eigen::Index>(j)) = measures[j].value(list);
    }
    results.precisions.row(row) = precision_at_levels(list, evaluation.curve, largest).transpose();
    results.relevant[i] = list.relevant;
    results.tied[i] = list.tied ? 1 : 0;
  });
  return results;
}

// The queries of each class, by evaluation.classes.
std::vector<std::vector<Eigen::Index>> queries_by_class(const Evaluation& evaluation) {
  std::map<int, std::vector<Eigen::Index>> queries;
  for (std::size_t i = 0; i < evaluation.query_classes.size(); ++i) {
    queries[evaluation.query_classes[i]].push_back(static_cast<Eigen::Index>(i));
  }
  std::vector<std::vector<Eigen::Index>> by_class;
  for (auto& [label, of_class] : queries) by_class.push_back(std::move(of_class));
  return by_class;
}

void draw_curves(const QueryResults& results, const std::vector<std::vector<Eigen::Index>>& groups,
                 const Eigen::MatrixXd& precisions_by_class, Evaluation& evaluation) {
  evaluation.micro_curve = average_curve(results.precisions, results.relevant, evaluation.curve);
  std::vector<std::size_t> relevant_of_class;  // a level counts for a class where it does for any of its queries
  for (const std::vector<Eigen::Index>& group : groups) {
    std::vector<std::size_t> relevant;
    for (const Eigen::Index i : group) relevant.push_back(results.relevant[static_cast<std::size_t>(i)]);
    relevant_of_class.push_back(*std::ranges::max_element(relevant));
    const Eigen::MatrixXd precisions = results.precisions(group, Eigen::all);
    evaluation.class_curves.push_back(average_curve(precisions, relevant, evaluation.curve));
  }
  evaluation.macro_curve = average_curve(precisions_by_class, relevant_of_class, evaluation.curve);
}

}  // namespace

Evaluation evaluate(const DistanceTable& distances, const RetrievalTask& task, const EvaluationOptions& options) {
  check_task(distances, task, options);
  if (!task.lists_may_end_early) check_numbers(distances);
  const std::vector<Measure> measures =
      options.measures.empty() ? default_measures(options.protocol) : options.measures;
  Evaluation evaluation;
  evaluation.protocol = options.protocol;
  evaluation.ties = options.ties;
  evaluation.curve = options.curve.value_or(usual_curve(options.protocol));
  for (const Measure& measure : measures) evaluation.measures.push_back(measure.name);
  choose_queries(task, options.minimum_class_size, evaluation);

  const QueryResults results = judge_queries(distances, task, measures, evaluation);
  const std::vector<std::vector<Eigen::Index>> groups = queries_by_class(evaluation);
  evaluation.per_query = results.measures;
  evaluation.per_class = mean_by_group(results.measures, groups);
  evaluation.micro = mean_of_rows(evaluation.per_query);
  evaluation.macro = mean_of_rows(evaluation.per_class);
  evaluation.queries_with_ties = std::count(results.tied.begin(), results.tied.end(), 1);
  draw_curves(results, groups, mean_by_group(results.precisions, groups), evaluation);
  return evaluation;
}

Evaluation evaluate(const DistanceTable& distances, std::span<const int> labels, const EvaluationOptions& options) {
  check_square(distances, labels);
  return evaluate(distances, leave_one_out(labels), options);
}

}  // namespace shapegauge
