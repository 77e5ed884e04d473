// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/metrics/evaluation.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel.h"

namespace shapegauge {
namespace {

constexpr std::string_view name_of_bounds = "FT";  // the measure of first_tier_bounds

void check_square(const DistanceTable& distances, std::span<const int> labels) {
  if (distances.rows() != distances.cols()) {
    throw ArgumentError("a distance matrix must be square, not " + std::to_string(distances.rows()) + " x " +
                        std::to_string(distances.cols()));
  }
  if (static_cast<std::size_t>(distances.rows()) != labels.size()) {
    throw ArgumentError("the distance matrix is for " + std::to_string(distances.rows()) + " models, but " +
                        std::to_string(labels.size()) + " have a class");
  }
}

void check_task(std::size_t rows, std::size_t columns, const RetrievalTask& task, const EvaluationOptions& options) {
  const bool fits = task.query_classes.size() == rows && task.own_column.size() == rows &&
                    task.target_classes.size() == columns && (task.judged.empty() || task.judged.size() == rows) &&
                    (!has_grades(task) || !task.judged.empty() ||
                     (task.query_subclasses.size() == rows && task.target_subclasses.size() == columns));
  if (!fits) {
    throw ArgumentError("the retrieval task is for " + std::to_string(task.query_classes.size()) + " queries and " +
                        std::to_string(task.target_classes.size()) + " targets, the distance matrix is " +
                        std::to_string(rows) + " x " + std::to_string(columns));
  }
  check_options("evaluation", evaluation_table, options);
}

// The first row is the matrix's row `first`.
void check_numbers(const DistanceTable& distances, Eigen::Index first) {
  for (Eigen::Index row = 0; row < distances.rows(); ++row) {
    for (Eigen::Index column = 0; column < distances.cols(); ++column) {
      if (!std::isnan(distances(row, column))) continue;
      throw ArgumentError("the distance in row " + std::to_string(first + row) + ", column " + std::to_string(column) +
                          " (counted from 0) is not a number");
    }
  }
}

RetrievalTask task_with(const EvaluationOptions& options, RetrievalTask task) {
  if (options.finds_itself) std::ranges::fill(task.own_column, -1);
  return task;
}

// Determines the rows that are queries, and the classes with queries.
void choose_queries(const RetrievalTask& task, int minimum_class_size, Evaluation& evaluation) {
  const std::vector<std::size_t> relevant = relevant_counts(task);
  const auto minimum = static_cast<std::size_t>(minimum_class_size);
  std::set<int> classes;
  for (std::size_t row = 0; row < relevant.size(); ++row) {
    if (task.query_classes[row] == no_class) continue;
    if (relevant[row] + 1 < minimum || (relevant[row] == 0 && task.judged.empty())) {
      ++evaluation.excluded_models;
      continue;
    }
    evaluation.queries.push_back(static_cast<Eigen::Index>(row));
    evaluation.query_classes.push_back(task.query_classes[row]);
    classes.insert(task.query_classes[row]);
  }
  if (classes.empty() && !task.judged.empty()) {
    throw ArgumentError(minimum <= 2 ? "no query has a relevant model"
                                     : "no query has " + std::to_string(minimum - 1) + " relevant models or more");
  }
  if (classes.empty()) {
    throw ArgumentError("no class has " + std::to_string(std::max<std::size_t>(minimum, 2)) +
                        " models or more, so there are no queries");
  }
  evaluation.classes.assign(classes.begin(), classes.end());
}

// Averages the rows of each group, in the order of the rows. No group may be empty.
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

// Returns the queries of each class, by evaluation.classes.
std::vector<std::vector<Eigen::Index>> queries_by_class(const Evaluation& evaluation) {
  std::map<int, std::vector<Eigen::Index>> queries;
  for (std::size_t i = 0; i < evaluation.query_classes.size(); ++i) {
    queries[evaluation.query_classes[i]].push_back(static_cast<Eigen::Index>(i));
  }
  std::vector<std::vector<Eigen::Index>> by_class;
  by_class.reserve(queries.size());
  for (auto& [label, of_class] : queries) by_class.push_back(std::move(of_class));
  return by_class;
}

void draw_curves(const QueryScores& results, const std::vector<std::vector<Eigen::Index>>& groups,
                 Evaluation& evaluation) {
  evaluation.micro_curve = average_curve(results.precisions, results.relevant, evaluation.curve);
  Eigen::MatrixXd of_classes(std::ssize(groups), results.precisions.cols());
  std::vector<std::size_t> relevant_of_class;  // a level counts for a class if it does for any query
  for (const std::vector<Eigen::Index>& group : groups) {
    std::vector<std::size_t> relevant;
    relevant.reserve(group.size());
    for (const Eigen::Index i : group) relevant.push_back(results.relevant[static_cast<std::size_t>(i)]);
    relevant_of_class.push_back(*std::ranges::max_element(relevant));
    const Eigen::MatrixXd precisions = results.precisions(group, Eigen::all);
    evaluation.class_curves.push_back(average_curve(precisions, relevant, evaluation.curve));
    const std::vector<double>& curve = evaluation.class_curves.back().precision;
    of_classes.row(std::ssize(evaluation.class_curves) - 1) =
        Eigen::Map<const Eigen::RowVectorXd>(curve.data(), std::ssize(curve));
  }
  evaluation.macro_curve = average_curve(of_classes, relevant_of_class, evaluation.curve);
}

}  // namespace

std::vector<Measure> evaluated_measures(const EvaluationOptions& options) {
  return options.measures.empty() ? default_measures(options.protocol) : options.measures;
}

std::map<std::string, int> measure_versions(const EvaluationOptions& options) {
  std::map<std::string, int> versions{{std::string(name_of_bounds), measure_of(name_of_bounds).definition->version}};
  for (const Measure& measure : evaluated_measures(options)) versions[measure.name] = measure.definition->version;
  return versions;
}

RowEvaluator::RowEvaluator(const RetrievalTask& task, const EvaluationOptions& options, Eigen::Index first,
                           Eigen::Index last)
    : relevance_(task), measures_(evaluated_measures(options)), first_tier_(measure_of(name_of_bounds)) {
  if (options.finds_itself && std::ranges::any_of(task.own_column, [](Eigen::Index column) { return column >= 0; })) {
    throw ArgumentError("with finds_itself, own_column must be -1 for all queries of the task");
  }
  check_task(task.query_classes.size(), task.target_classes.size(), task, options);
  blank_.protocol = options.protocol;
  blank_.ties = options.ties;
  blank_.curve = options.curve.value_or(default_curve(options.protocol));
  for (const Measure& measure : measures_) blank_.measures.push_back(measure.name);
  choose_queries(task, options.minimum_class_size, blank_);
  largest_ = std::ranges::max(relevant_counts(task)) + (blank_.protocol == Protocol::paper ? 1 : 0);

  const auto begin = std::ranges::lower_bound(blank_.queries, first);
  const auto count = std::ranges::lower_bound(blank_.queries, last) - begin;
  first_query_ = static_cast<std::size_t>(begin - blank_.queries.begin());
  scores_.measures.resize(count, std::ssize(measures_));
  scores_.precisions.resize(count, std::ssize(recall_levels(blank_.curve, largest_)));
  scores_.relevant.resize(static_cast<std::size_t>(count));
  scores_.tied.resize(static_cast<std::size_t>(count));
  scores_.first_tiers.resize(count, Eigen::NoChange);
}

template <typename ListOf>
void RowEvaluator::evaluate_rows(Eigen::Index first, Eigen::Index last, const ListOf& list_of) {
  const auto begin = std::ranges::lower_bound(blank_.queries, first) - blank_.queries.begin();
  const auto end = std::ranges::lower_bound(blank_.queries, last) - blank_.queries.begin();
  parallel_for(begin, end, [&](std::ptrdiff_t query) {
    const auto i = static_cast<std::size_t>(query);
    std::optional<TieExtremes> extremes;
    const RankedList list = list_of(blank_.queries[i], extremes);
    keep(i - first_query_, list);
    scores_.first_tiers.row(query - static_cast<std::ptrdiff_t>(first_query_))
        << first_tier_.value(extremes ? extremes->pessimistic : list),
        first_tier_.value(extremes ? extremes->optimistic : list);
  });
}

void RowEvaluator::evaluate(const DistanceTable& rows, Eigen::Index first) {
  check_numbers(rows, first);
  evaluate_rows(first, first + rows.rows(), [&](Eigen::Index row, std::optional<TieExtremes>& extremes) {
    const std::span<const double> distances(&rows.coeffRef(row - first, 0), static_cast<std::size_t>(rows.cols()));
    return ranked_list(distances, relevance_, row, {.protocol = blank_.protocol, .ties = blank_.ties}, &extremes);
  });
}

void RowEvaluator::evaluate(const RankedAnswerLists& answers) {
  evaluate_rows(0, std::ssize(answers), [&](Eigen::Index row, std::optional<TieExtremes>& extremes) {
    return ranked_list(answers[static_cast<std::size_t>(row)], relevance_, row,
                       {.protocol = blank_.protocol, .ties = blank_.ties}, &extremes);
  });
}

void RowEvaluator::keep(std::size_t score, const RankedList& list) {
  const auto row = static_cast<Eigen::Index>(score);
  for (std::size_t j = 0; j < measures_.size(); ++j) {
    scores_.measures(row, static_cast<Eigen::Index>(j)) = measures_[j].value(list);
  }
  scores_.precisions.row(row) = precision_at_levels(list, blank_.curve, largest_).transpose();
  scores_.relevant[score] = list.relevant;
  scores_.tied[score] = list.tied ? 1 : 0;
}

Evaluation RowEvaluator::evaluation_of(const QueryScores& all) const {
  Evaluation evaluation = blank_;
  const std::vector<std::vector<Eigen::Index>> groups = queries_by_class(evaluation);
  evaluation.per_query = all.measures;
  evaluation.per_class = mean_by_group(all.measures, groups);
  evaluation.micro = mean_of_rows(evaluation.per_query);
  evaluation.macro = mean_of_rows(evaluation.per_class);
  evaluation.queries_with_ties = std::count(all.tied.begin(), all.tied.end(), 1);
  const Eigen::VectorXd bounds = mean_of_rows(all.first_tiers);
  evaluation.first_tier_bounds = {.pessimistic = bounds[0], .optimistic = bounds[1]};
  draw_curves(all, groups, evaluation);
  return evaluation;
}

Evaluation evaluate(const DistanceTable& distances, const RetrievalTask& task, const EvaluationOptions& options) {
  check_task(static_cast<std::size_t>(distances.rows()), static_cast<std::size_t>(distances.cols()), task, options);
  const RetrievalTask adapted = task_with(options, task);
  RowEvaluator evaluator(adapted, options, 0, distances.rows());
  evaluator.evaluate(distances, 0);
  return evaluator.evaluation_of(evaluator.scores());
}

Evaluation evaluate(const RowSource& distances, const RetrievalTask& task, const EvaluationOptions& options) {
  constexpr Eigen::Index together = 256;
  const auto rows = static_cast<Eigen::Index>(task.query_classes.size());
  check_task(task.query_classes.size(), task.target_classes.size(), task, options);
  const RetrievalTask adapted = task_with(options, task);
  RowEvaluator evaluator(adapted, options, 0, rows);
  for (Eigen::Index first = 0; first < rows; first += together) {
    const Eigen::Index count = std::min(together, rows - first);
    const DistanceMatrix some = distances(first, count);
    if (some.rows() != count || some.cols() != std::ssize(task.target_classes)) {
      throw ArgumentError("expected " + std::to_string(count) + " rows of " +
                          std::to_string(task.target_classes.size()) + " distances, got " +
                          std::to_string(some.rows()) + " of " + std::to_string(some.cols()));
    }
    evaluator.evaluate(some, first);
  }
  return evaluator.evaluation_of(evaluator.scores());
}

Evaluation evaluate(const RankedAnswerLists& answers, const RetrievalTask& task, const EvaluationOptions& options) {
  check_task(answers.size(), task.target_classes.size(), task, options);
  const RetrievalTask adapted = task_with(options, task);
  RowEvaluator evaluator(adapted, options, 0, std::ssize(answers));
  evaluator.evaluate(answers);
  return evaluator.evaluation_of(evaluator.scores());
}

Evaluation evaluate(const DistanceTable& distances, std::span<const int> labels, const EvaluationOptions& options) {
  check_square(distances, labels);
  return evaluate(distances, leave_one_out(labels), options);
}

}  // namespace shapegauge
