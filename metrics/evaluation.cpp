#include "shapegauge/metrics/evaluation.h"

#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <tbb/parallel_for.h>

#include "shapegauge/metrics/measures/registry.h"
#include "shapegauge/metrics/ranked_list.h"

namespace shapegauge {
namespace {

using ClassSizes = std::map<int, std::size_t>;

void check_input(const DistanceTable& distances, std::span<const int> labels, const EvaluationOptions& options) {
  if (distances.rows() != distances.cols()) {
    throw std::invalid_argument("a distance matrix must be square, not " + std::to_string(distances.rows()) + " x " +
                                std::to_string(distances.cols()));
  }
  if (static_cast<std::size_t>(distances.rows()) != labels.size()) {
    throw std::invalid_argument("the distance matrix is for " + std::to_string(distances.rows()) + " models, but " +
                                std::to_string(labels.size()) + " have a class");
  }
  if (options.minimum_class_size < 2) {
    throw std::invalid_argument("the minimum class size must be at least 2, not " +
                                std::to_string(options.minimum_class_size) +
                                ": a class of one model has no relevant answer");
  }
  for (Eigen::Index row = 0; row < distances.rows(); ++row) {
    for (Eigen::Index column = 0; column < distances.cols(); ++column) {
      if (!std::isnan(distances(row, column))) continue;
      throw std::invalid_argument("the distance in row " + std::to_string(row) + ", column " + std::to_string(column) +
                                  " (counted from 0) is not a number");
    }
  }
}

ClassSizes sizes_of(std::span<const int> labels) {
  ClassSizes sizes;
  for (const int label : labels) ++sizes[label];
  return sizes;
}

// The models that are queries, and the classes that have queries.
void choose_queries(std::span<const int> labels, const ClassSizes& sizes, int minimum_class_size,
                    Evaluation& evaluation) {
  const auto minimum = static_cast<std::size_t>(minimum_class_size);
  for (const auto& [label, size] : sizes) {
    if (size >= minimum) evaluation.classes.push_back(label);
  }
  if (evaluation.classes.empty()) {
    throw std::invalid_argument("no class has " + std::to_string(minimum) + " models or more, so there are no queries");
  }
  for (std::size_t model = 0; model < labels.size(); ++model) {
    if (sizes.at(labels[model]) >= minimum) evaluation.queries.push_back(static_cast<Eigen::Index>(model));
  }
  evaluation.models_left_out = static_cast<Eigen::Index>(labels.size() - evaluation.queries.size());
}

// Mean of the rows in each group, in the order of the rows. Every group has rows.
Eigen::MatrixXd mean_by_group(const Eigen::MatrixXd& table, std::span<const Eigen::Index> group_of_row,
                              Eigen::Index groups) {
  Eigen::MatrixXd means = Eigen::MatrixXd::Zero(groups, table.cols());
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(groups);
  for (Eigen::Index row = 0; row < table.rows(); ++row) {
    const Eigen::Index group = group_of_row[static_cast<std::size_t>(row)];
    means.row(group) += table.row(row);
    counts[group] += 1;
  }
  for (Eigen::Index group = 0; group < groups; ++group) means.row(group) /= counts[group];
  return means;
}

Eigen::VectorXd mean_of_rows(const Eigen::MatrixXd& table) {
  const std::vector<Eigen::Index> one_group(static_cast<std::size_t>(table.rows()), 0);
  return mean_by_group(table, one_group, 1).row(0).transpose();
}

struct QueryResults {
  Eigen::MatrixXd measures;           // queries x measures
  Eigen::MatrixXd precisions;         // queries x recall levels
  std::vector<std::size_t> relevant;  // of each query
};

QueryResults judge_queries(const DistanceTable& distances, std::span<const int> labels,
                           std::span<const Eigen::Index> queries, Protocol protocol) {
  const auto all = measures();
  const auto count = static_cast<Eigen::Index>(queries.size());
  QueryResults results;
  results.measures.resize(count, static_cast<Eigen::Index>(all.size()));
  results.precisions.resize(count, static_cast<Eigen::Index>(recall_levels(protocol).size()));
  results.relevant.resize(queries.size());
  tbb::parallel_for(std::size_t{0}, queries.size(), [&](std::size_t i) {
    const auto row = static_cast<Eigen::Index>(i);
    const RankedList list = ranked_list(distances, labels, queries[i], protocol);
    for (std::size_t j = 0; j < all.size(); ++j) {
      results.measures(row, static_cast<Eigen::Index>(j)) = all[j].value(list);
    }
    results.precisions.row(row) = precision_at_levels(list, protocol).transpose();
    results.relevant[i] = list.relevant;
  });
  return results;
}

}  // namespace

Evaluation evaluate(const DistanceTable& distances, std::span<const int> labels, const EvaluationOptions& options) {
  check_input(distances, labels, options);
  Evaluation evaluation;
  evaluation.protocol = options.protocol;
  for (const Measure& measure : measures()) evaluation.measures.emplace_back(measure.name);
  choose_queries(labels, sizes_of(labels), options.minimum_class_size, evaluation);

  const QueryResults results = judge_queries(distances, labels, evaluation.queries, options.protocol);
  std::map<int, Eigen::Index> group_of_label;
  for (const int label : evaluation.classes) {
    group_of_label.emplace(label, static_cast<Eigen::Index>(group_of_label.size()));
  }
  const auto classes = static_cast<Eigen::Index>(evaluation.classes.size());
  std::vector<Eigen::Index> group_of_query;
  std::vector<std::size_t> relevant_of_class(evaluation.classes.size());
  for (std::size_t i = 0; i < evaluation.queries.size(); ++i) {
    const Eigen::Index group = group_of_label.at(labels[static_cast<std::size_t>(evaluation.queries[i])]);
    group_of_query.push_back(group);
    relevant_of_class[static_cast<std::size_t>(group)] = results.relevant[i];
  }

  evaluation.per_query = results.measures;
  evaluation.per_class = mean_by_group(results.measures, group_of_query, classes);
  evaluation.micro = mean_of_rows(evaluation.per_query);
  evaluation.macro = mean_of_rows(evaluation.per_class);
  evaluation.micro_curve = average_curve(results.precisions, results.relevant, options.protocol);
  evaluation.macro_curve =
      average_curve(mean_by_group(results.precisions, group_of_query, classes), relevant_of_class, options.protocol);
  return evaluation;
}

}  // namespace shapegauge
