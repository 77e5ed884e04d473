// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/query_expansion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/retrieval/nearest_models.h"

namespace shapegauge {

namespace {

constexpr std::array expansion_table = {
    option_of<&ExpansionOptions::neighbours>("neighbours", {.low = 1, .high = 1000},
                                             "Number of nearest models to average distances over; results for a list "
                                             "(auto: 4,5,7,10,14,20) are averaged.",
                                             automatic_neighbours),
};
constexpr auto expansion_parameters = parameters_of(expansion_table);

/// Returns true if a column is infinite in the row and in those of its nearest neighbours.
bool is_far_from_all(const DistanceMatrix& distances, const NearestModels& nearest, Eigen::Index row,
                     Eigen::Index column) {
  const auto is_far = [&](Eigen::Index i) { return i != column && std::isinf(distances(i, column)); };
  return is_far(row) &&
         std::ranges::all_of(nearest.indices.row(row), [&](std::int32_t other) { return other < 0 || is_far(other); });
}

/// Returns the weights of the nearest neighbours' rows relative to the model's own row: the r-th has 1 / (1 + r) of
/// it in the mean of the first k rows, for each of the counts k that include it.
std::vector<double> neighbour_weights(Eigen::Index neighbours, const std::vector<int>& counts) {
  std::vector<double> totals{1};
  for (Eigen::Index r = 1; r <= neighbours; ++r) totals.push_back(totals.back() + 1 / static_cast<double>(r + 1));
  const auto shares = [&](Eigen::Index rank) {
    double sum = 0;
    for (const int count : counts) {
      if (count >= rank) sum += 1 / totals[static_cast<std::size_t>(std::min<Eigen::Index>(count, neighbours))];
    }
    return sum;
  };
  std::vector<double> weights;
  for (Eigen::Index r = 1; r <= neighbours; ++r) {
    weights.push_back(shares(r) / shares(0) * (1 / static_cast<double>(r + 1)));
  }
  return weights;
}

}  // namespace

DistanceMatrix query_expansion(const DistanceMatrix& distances, const ExpansionOptions& options) {
  check_options("query_expansion", expansion_table, options);
  const std::vector<int> counts = neighbour_counts(options.neighbours);
  const NearestModels nearest = nearest_models(distances.rows(), counts.back(), rows_of(distances));
  const double factor = overflow_safe_factor(nearest.largest);
  DistanceMatrix finite = distances.array().isInf().select(nearest.largest, distances) * factor;
  finite.diagonal().setZero();
  DistanceMatrix result = finite;
  parallel_for(Eigen::Index{0}, distances.rows(), [&](Eigen::Index i) {
    const std::vector<double> weights = neighbour_weights((nearest.indices.row(i).array() >= 0).count(), counts);
    double total = 1;
    for (std::size_t n = 0; n < weights.size(); ++n) {
      result.row(i) += weights[n] * finite.row(nearest.indices(i, static_cast<Eigen::Index>(n)));
      total += weights[n];
    }
    result.row(i) /= total * factor;
    for (Eigen::Index j = 0; j < result.cols(); ++j) {
      result(i, j) = std::min(result(i, j), std::numeric_limits<double>::max());
      if (is_far_from_all(distances, nearest, i, j)) result(i, j) = std::numeric_limits<double>::infinity();
    }
  });
  return symmetrise(result);
}

RerankMethod query_expansion_method() {
  return {"query_expansion",
          "Average query expansion: each model's distances are averaged with those of its nearest models.",
          expansion_parameters, [](const DistanceMatrix& distances, const ParameterValues& values) {
            return query_expansion(distances, options_from(expansion_table, values));
          }};
}

}  // namespace shapegauge
