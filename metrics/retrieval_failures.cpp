// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/metrics/retrieval_failures.h"

#include <algorithm>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/metrics/ascending_order.h"

namespace shapegauge {

Eigen::MatrixXi confusion_matrix(std::span<const std::int32_t> nearest, std::span<const int> labels,
                                 std::span<const Eigen::Index> queries, int classes) {
  const auto models = std::ssize(labels);
  const auto is_class = [&](int label) { return label >= 0 && label < classes; };
  const auto is_model = [&](auto model) { return model >= 0 && model < models; };
  if (nearest.size() != labels.size()) {
    throw ArgumentError("there are " + std::to_string(nearest.size()) + " nearest neighbours for " +
                        std::to_string(labels.size()) + " labels of models");
  }
  if (!std::ranges::all_of(labels, is_class)) {
    throw ArgumentError("a label is not a class from 0 to " + std::to_string(classes - 1));
  }
  if (!std::ranges::all_of(nearest, is_model) || !std::ranges::all_of(queries, is_model)) {
    throw ArgumentError("a query, or its nearest neighbour, is not one of the models 0 to " +
                        std::to_string(models - 1));
  }
  Eigen::MatrixXi confusion = Eigen::MatrixXi::Zero(classes, classes);
  for (const Eigen::Index query : queries) {
    const auto answer = static_cast<std::size_t>(nearest[static_cast<std::size_t>(query)]);
    ++confusion(labels[static_cast<std::size_t>(query)], labels[answer]);
  }
  return confusion;
}

std::vector<std::size_t> worst_queries(const Evaluation& evaluation, std::string_view measure, std::size_t count) {
  const auto column = std::ranges::find(evaluation.measures, measure);
  if (column == evaluation.measures.end()) {
    throw ArgumentError("the measure " + std::string(measure) + " was not evaluated; add it to the measures");
  }
  const auto values = evaluation.per_query.col(column - evaluation.measures.begin());
  std::vector<std::size_t> order = ascending_order(values);
  order.resize(std::min(count, order.size()));
  return order;
}

}  // namespace shapegauge
