// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/metrics/chance.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>

namespace shapegauge {

std::optional<NearestNeighbourByChance> compare_nearest_with_chance(const Evaluation& evaluation,
                                                                    const RetrievalTask& task) {
  const auto measure = std::ranges::find(evaluation.measures, "NN");
  if (measure == evaluation.measures.end()) return std::nullopt;
  const std::vector<std::size_t> relevant = relevant_counts(task);
  const auto is_target = [&](Eigen::Index column) {
    return column >= 0 && task.target_classes[static_cast<std::size_t>(column)] != no_class;
  };
  const auto targets = static_cast<double>(task.target_classes.size()) -
                       static_cast<double>(std::ranges::count(task.target_classes, no_class));
  const auto queries = static_cast<double>(evaluation.queries.size());
  NearestNeighbourByChance chance{.found = evaluation.micro[measure - evaluation.measures.begin()]};
  for (const Eigen::Index row : evaluation.queries) {
    const auto i = static_cast<std::size_t>(row);
    const double others = targets - (is_target(task.own_column[i]) ? 1 : 0);
    chance.expected += static_cast<double>(relevant[i]) / others / queries;
  }
  // A sum of trials of different probabilities varies less than one of equal probabilities.
  const boost::math::binomial trials(queries, std::min(chance.expected, 1.0));
  chance.probability = boost::math::cdf(trials, std::round(chance.found * queries));
  return chance;
}

}  // namespace shapegauge
