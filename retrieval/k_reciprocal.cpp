// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/k_reciprocal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/retrieval/nearest_models.h"

namespace shapegauge {

namespace {

using SparseRow = std::vector<std::pair<std::int32_t, double>>;  // per column

constexpr std::array reciprocal_table = {
    option_of<&ReciprocalOptions::neighbours>("neighbours", {.low = 1, .high = 1000},
                                              "Number of nearest models that may be mutual neighbours; results for a "
                                              "list (auto: 4,5,7,10,14,20) are averaged.",
                                              automatic_neighbours),
    option_of<&ReciprocalOptions::expansion_neighbours>("expansion_neighbours", {.low = 1, .high = 1000},
                                                        "Number of nearest models whose neighbour sets are averaged; "
                                                        "at most the largest value of neighbours."),
    option_of<&ReciprocalOptions::original>("original", {.low = 0, .high = 1},
                                            "Weight of the original distance; 1: no re-ranking."),
};
constexpr auto reciprocal_parameters = parameters_of(reciprocal_table);

/// Returns true if `other` is among the k nearest of `model`.
bool is_near(const NearestModels& nearest, std::int32_t model, std::int32_t other, Eigen::Index k) {
  const auto row = nearest.indices.row(model).head(std::min(k, nearest.indices.cols()));
  return (row.array() == other).any();
}

/// Returns the model and those of its k nearest that have it among theirs, ascending.
std::vector<std::int32_t> reciprocal_neighbours(const NearestModels& nearest, std::int32_t model, Eigen::Index k) {
  std::vector<std::int32_t> mutual = {model};
  for (const std::int32_t other : nearest.indices.row(model).head(std::min(k, nearest.indices.cols()))) {
    if (other >= 0 && is_near(nearest, other, model, k)) mutual.push_back(other);
  }
  std::ranges::sort(mutual);
  return mutual;
}

/// Returns the reciprocal neighbours, extended by the sets of half the size of those neighbours of which two thirds are
/// among them.
std::vector<std::int32_t> expanded_neighbours(const NearestModels& nearest, std::int32_t model, Eigen::Index k) {
  const std::vector<std::int32_t> mutual = reciprocal_neighbours(nearest, model, k);
  std::vector<std::int32_t> expanded = mutual;
  for (const std::int32_t other : mutual) {
    const std::vector<std::int32_t> theirs = reciprocal_neighbours(nearest, other, std::max<Eigen::Index>(k / 2, 1));
    std::vector<std::int32_t> common;
    std::ranges::set_intersection(theirs, mutual, std::back_inserter(common));
    if (3 * common.size() > 2 * theirs.size()) expanded.insert(expanded.end(), theirs.begin(), theirs.end());
  }
  std::ranges::sort(expanded);
  expanded.erase(std::unique(expanded.begin(), expanded.end()), expanded.end());
  return expanded;
}

/// Returns a model's neighbours with Gaussian weights that sum to 1.
SparseRow encoded(const DistanceMatrix& distances, const NearestModels& nearest, std::int32_t model, Eigen::Index k) {
  SparseRow row;
  const double unit = mean_distance(nearest.distances.row(model).head(std::min(k, nearest.distances.cols())));
  double total = 0;
  for (const std::int32_t other : expanded_neighbours(nearest, model, k)) {
    const double distance = other == model ? 0 : distances(model, other);
    const double weight = unit > 0 || std::isinf(distance) ? std::exp(-distance / unit) : 1;
    row.emplace_back(other, weight);
    total += weight;
  }
  for (auto& entry : row) entry.second /= total;
  return row;
}

/// Averages the rows of the model and its nearest neighbours, at most `most` rows.
SparseRow mean_row(const std::vector<SparseRow>& rows, const NearestModels& nearest, std::int32_t model,
                   Eigen::Index most) {
  SparseRow sum = rows[static_cast<std::size_t>(model)];
  std::size_t count = 1;
  for (const std::int32_t other : nearest.indices.row(model).head(std::min(most - 1, nearest.indices.cols()))) {
    if (other < 0) break;
    ++count;
    const SparseRow& row = rows[static_cast<std::size_t>(other)];
    sum.insert(sum.end(), row.begin(), row.end());
  }
  std::ranges::sort(sum);
  SparseRow merged;
  for (const auto& [column, weight] : sum) {
    if (merged.empty() || merged.back().first != column) merged.emplace_back(column, 0);
    merged.back().second += weight / static_cast<double>(count);
  }
  return merged;
}

/// Sets of neighbours of all models.
struct NeighbourSets {
  std::vector<SparseRow> rows;
  std::vector<SparseRow> columns;  ///< transposed: by neighbour
  Eigen::RowVectorXd sums;         ///< of the rows
};

NeighbourSets neighbour_sets(const DistanceMatrix& distances, const NearestModels& nearest, Eigen::Index k,
                             Eigen::Index expansion) {
  const auto size = static_cast<std::size_t>(distances.rows());
  std::vector<SparseRow> codes(size);
  NeighbourSets sets{std::vector<SparseRow>(size), std::vector<SparseRow>(size),
                     Eigen::RowVectorXd::Zero(distances.rows())};
  parallel_for(std::size_t{0}, size,
               [&](std::size_t i) { codes[i] = encoded(distances, nearest, static_cast<std::int32_t>(i), k); });
  parallel_for(std::size_t{0}, size, [&](std::size_t i) {
    sets.rows[i] = mean_row(codes, nearest, static_cast<std::int32_t>(i), std::min(expansion, distances.rows()));
  });
  for (std::size_t i = 0; i < size; ++i) {
    for (const auto& [column, weight] : sets.rows[i]) {
      sets.columns[static_cast<std::size_t>(column)].emplace_back(static_cast<std::int32_t>(i), weight);
      sets.sums[static_cast<Eigen::Index>(i)] += weight;
    }
  }
  return sets;
}

/// Computes 1 - sum of minima / sum of maxima, of one row with all.
Eigen::RowVectorXd jaccard_distances(const NeighbourSets& sets, Eigen::Index model) {
  Eigen::RowVectorXd minima = Eigen::RowVectorXd::Zero(sets.sums.size());
  for (const auto& [column, weight] : sets.rows[static_cast<std::size_t>(model)]) {
    for (const auto& [other, others_weight] : sets.columns[static_cast<std::size_t>(column)]) {
      minima[other] += std::min(weight, others_weight);
    }
  }
  return 1 - minima.array() / (sets.sums.array() + sets.sums[model] - minima.array());
}

/// Averages over the numbers of neighbours.
Eigen::RowVectorXd mean_jaccard_distances(const std::vector<NeighbourSets>& of_counts, Eigen::Index model) {
  Eigen::RowVectorXd sum = jaccard_distances(of_counts.front(), model);
  for (std::size_t k = 1; k < of_counts.size(); ++k) sum += jaccard_distances(of_counts[k], model);
  return sum / static_cast<double>(of_counts.size());
}

void check_reciprocal(const ReciprocalOptions& options) {
  check_options("k_reciprocal", reciprocal_table, options);
  const int most = neighbour_counts(options.neighbours).back();
  if (!options.neighbours.empty() && options.expansion_neighbours > most) {
    throw InputError("k_reciprocal: expansion_neighbours is " + std::to_string(options.expansion_neighbours) +
                     "; it must be at most neighbours, which is " + std::to_string(most));
  }
}

}  // namespace

DistanceMatrix k_reciprocal(const DistanceMatrix& distances, const ReciprocalOptions& options) {
  check_reciprocal(options);
  const Eigen::Index models = distances.rows();
  const std::vector<int> counts = neighbour_counts(options.neighbours);
  const NearestModels found = nearest_models(models, counts.back(), rows_of(distances));
  if (models < 2) return symmetrise(distances);
  const double factor = overflow_safe_factor(found.largest);
  const NearestModels nearest = with_scaled_distances(found, factor);
  const DistanceMatrix scaled = factor * distances;
  std::vector<NeighbourSets> sets;
  for (const int count : counts) {
    sets.push_back(neighbour_sets(scaled, nearest, count, std::min(options.expansion_neighbours, count)));
  }
  const double share = nearest.largest > 0 ? options.original / nearest.largest : 0;
  DistanceMatrix result(models, models);
  parallel_for(Eigen::Index{0}, models, [&](Eigen::Index model) {
    const Eigen::RowVectorXd jaccard = mean_jaccard_distances(sets, model);
    result.row(model) = (1 - options.original) * jaccard + share * scaled.row(model);
    for (Eigen::Index j = 0; j < models; ++j) {
      if (!std::isinf(scaled(model, j))) continue;
      result(model, j) = jaccard[j] < 1 ? (1 - options.original) * jaccard[j] + options.original
                                        : std::numeric_limits<double>::infinity();
    }
  });
  return symmetrise(result);
}

RerankMethod k_reciprocal_method() {
  return {.name = "k_reciprocal",
          .description = "k-reciprocal re-ranking: Jaccard distance between sets of mutual neighbours.",
          .parameters = reciprocal_parameters,
          .rerank =
              [](const DistanceMatrix& distances, const ParameterValues& values) {
                return k_reciprocal(distances, options_from(reciprocal_table, values));
              },
          .check = [](const ParameterValues& values) { check_reciprocal(options_from(reciprocal_table, values)); }};
}

}  // namespace shapegauge
