// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/fusion.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/median.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/retrieval/local_scales.h"
#include "shapegauge/retrieval/mutual_ranks.h"
#include "shapegauge/retrieval/rerank.h"

namespace shapegauge {

namespace {

void check(std::span<const DistanceMatrix> matrices, std::span<const double> weights) {
  check_sum_weights(matrices.size(), weights);
  const Eigen::Index size = matrices.front().rows();
  for (std::size_t k = 0; k < matrices.size(); ++k) {
    const DistanceMatrix& matrix = matrices[k];
    if (matrix.rows() != size || matrix.cols() != size) {
      throw ArgumentError("fused distance matrices must be square and of one size; there are " + std::to_string(size) +
                          " models and a matrix of " + std::to_string(matrix.rows()) + " x " +
                          std::to_string(matrix.cols()));
    }
    check_distances(matrix, 0, " of fused matrix " + std::to_string(k));
  }
}

/// Returns the finite distances between different models.
std::vector<double> finite_distances(const DistanceMatrix& matrix) {
  std::vector<double> distances;
  distances.reserve(static_cast<std::size_t>(matrix.size()));
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      if (i != j && std::isfinite(matrix(i, j))) distances.push_back(matrix(i, j));
    }
  }
  return distances;
}

/// Computes the locally scaled distances: matrix(i, j) / (roots[i] roots[j]).
DistanceMatrix locally_scaled(const DistanceMatrix& matrix) {
  Eigen::VectorXd means(matrix.rows());
  parallel_for(Eigen::Index{0}, matrix.rows(), [&](Eigen::Index i) {
    means[i] = mean_distance_to_nearest({matrix.row(i).data(), static_cast<std::size_t>(matrix.cols())}, i);
  });
  const LocalScales scales = LocalScales::of_means(means);
  DistanceMatrix scaled(matrix.rows(), matrix.cols());
  parallel_for(Eigen::Index{0}, matrix.rows(),
               [&](Eigen::Index i) { scaled.row(i) = scales.scaled(matrix.row(i), scales.roots[i]); });
  return scaled;
}

/// Computes sum += weight log(1 + mutual rank).
void add_log_ranks(const DistanceMatrix& matrix, double weight, DistanceMatrix& sum) {
  const auto row = [&](Eigen::Index i) {
    return std::span(matrix.row(i).data(), static_cast<std::size_t>(matrix.cols()));
  };
  DistanceMatrix at_ranks(matrix.rows(), sampled_rank_count(matrix.rows()));
  parallel_for(Eigen::Index{0}, matrix.rows(),
               [&](Eigen::Index i) { at_ranks.row(i) = distances_at_ranks(row(i), i); });
  parallel_for(Eigen::Index{0}, matrix.rows(),
               [&](Eigen::Index i) { sum.row(i) += weight * log_mutual_ranks(row(i), at_ranks.row(i), at_ranks); });
}

/// Replaces sums that are not finite: by infinity if a summand is infinite, otherwise by the largest number.
void settle_infinite(std::span<const DistanceMatrix> matrices, std::span<const double> weights, DistanceMatrix& sum) {
  for (Eigen::Index i = 0; i < sum.rows(); ++i) {
    for (Eigen::Index j = 0; j < sum.cols(); ++j) {
      if (std::isfinite(sum(i, j))) continue;
      bool infinite = false;
      for (std::size_t k = 0; k < matrices.size(); ++k) {
        infinite = infinite || (weights[k] > 0 && std::isinf(matrices[k](i, j)));
      }
      sum(i, j) = infinite ? std::numeric_limits<double>::infinity() : std::numeric_limits<double>::max();
    }
  }
}

/// By model: itself and its k nearest, ascending.
struct NearestSets {
  std::size_t count = 0;  ///< k
  std::vector<std::vector<std::int32_t>> of;
};

/// Computes the sets for several k. Nearest models must be strictly nearer than the next one; ties with it are
/// excluded.
std::vector<NearestSets> nearest_sets(const NearestModels& nearest, const std::vector<int>& counts) {
  std::vector<NearestSets> all;
  for (const int count : counts) {
    NearestSets& sets = all.emplace_back();
    sets.count = static_cast<std::size_t>(count);
    for (Eigen::Index i = 0; i < nearest.indices.rows(); ++i) {
      const bool has_next = count < nearest.indices.cols() && nearest.indices(i, count) >= 0;
      const double limit = has_next ? nearest.distances(i, count) : std::numeric_limits<double>::infinity();
      std::vector<std::int32_t>& set = sets.of.emplace_back(1, static_cast<std::int32_t>(i));
      for (Eigen::Index n = 0; n < nearest.indices.cols() && nearest.distances(i, n) < limit; ++n) {
        set.push_back(nearest.indices(i, n));
      }
      std::ranges::sort(set);
    }
  }
  return all;
}

/// Returns the number of models in both sets.
double common_models(const std::vector<std::int32_t>& a, const std::vector<std::int32_t>& b) {
  double common = 0;
  auto other = b.begin();
  for (const std::int32_t model : a) {
    other = std::find_if(other, b.end(), [&](std::int32_t candidate) { return candidate >= model; });
    common += other != b.end() && *other == model ? 1 : 0;
  }
  return common;
}

/// Sums per_model(i) in the models' order.
template <typename PerModel>
double sum_over_models(std::size_t models, const PerModel& per_model) {
  std::vector<double> values(models);
  parallel_for(std::size_t{0}, models, [&](std::size_t i) { values[i] = per_model(i); });
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Returns the mean share of a model's nearest that are also among its nearest by the other matrix.
double agreement(const NearestSets& one, const NearestSets& other) {
  const double common = sum_over_models(
      one.of.size(), [&](std::size_t i) { return common_models(one.of[i], other.of[i]) - 1; });  // itself
  return common / static_cast<double>(one.of.size() * one.count);
}

/// Returns the mean Jaccard index of a model's set and the sets of its nearest.
double cohesion(const NearestSets& sets) {
  const double sum = sum_over_models(sets.of.size(), [&](std::size_t i) {
    double jaccard_sum = 0;
    for (const std::int32_t near : sets.of[i]) {
      const auto other = static_cast<std::size_t>(near);
      if (other == i) continue;
      const double common = common_models(sets.of[i], sets.of[other]);
      jaccard_sum += common / (static_cast<double>(sets.of[i].size() + sets.of[other].size()) - common);
    }
    return jaccard_sum;
  });
  return sum / static_cast<double>(sets.of.size() * sets.count);
}

/// Nearest models by a matrix, for several k; none for a matrix of weight 0.
using SetsOfMatrix = std::vector<NearestSets>;

double mean_agreement(const SetsOfMatrix& one, const SetsOfMatrix& other) {
  double sum = 0;
  for (std::size_t n = 0; n < one.size(); ++n) sum += agreement(one[n], other[n]);
  return sum / static_cast<double>(one.size());
}

double mean_cohesion(const SetsOfMatrix& sets) {
  double sum = 0;
  for (const NearestSets& of_count : sets) sum += cohesion(of_count);
  return sum / static_cast<double>(sets.size());
}

/// Returns the sets by matrix; none if fewer than two weights are positive, or there are too few models.
std::vector<SetsOfMatrix> sets_by_matrix(std::span<const NearestModels> nearest, std::span<const double> weights) {
  Eigen::Index models = 0;
  for (const NearestModels& one : nearest) models = std::max(models, one.indices.rows());
  const auto positive = std::ranges::count_if(weights, [](double weight) { return weight > 0; });
  std::vector<int> counts = neighbour_counts({});
  std::erase_if(counts,
                [&](int count) { return count >= models - 1; });  // the set of all others carries no information
  if (positive < 2 || counts.empty()) return {};
  std::vector<SetsOfMatrix> sets(nearest.size());
  for (std::size_t k = 0; k < nearest.size(); ++k) {
    if (weights[k] > 0) sets[k] = nearest_sets(nearest[k], counts);
  }
  return sets;
}

/// Returns the factors by matrix; 0 for a weight of 0.
std::vector<double> agreement_factors(const std::vector<SetsOfMatrix>& sets, std::span<const double> weights) {
  std::vector<double> factors(sets.size());
  for (std::size_t k = 0; k < sets.size(); ++k) {
    double agreeing = 0;
    double others = 0;
    for (std::size_t other = 0; other < sets.size(); ++other) {
      if (other == k || weights[other] == 0 || weights[k] == 0) continue;
      others += weights[other];
      agreeing += weights[other] * mean_agreement(sets[k], sets[other]);
    }
    if (agreeing > 0) factors[k] = std::pow(agreeing / others * mean_cohesion(sets[k]), 4);
  }
  return factors;
}

std::vector<NearestModels> nearest_by_matrix(std::span<const DistanceMatrix> matrices,
                                             std::span<const double> weights) {
  std::vector<NearestModels> nearest(matrices.size());
  for (std::size_t k = 0; k < matrices.size(); ++k) {
    if (weights[k] == 0) continue;
    nearest[k] = nearest_models(matrices[k].rows(), nearest_for_weights(), rows_of(matrices[k]));
  }
  return nearest;
}

double score_of(Eigen::Index rank, Eigen::Index models, RankScore score) {
  constexpr double rank_constant = 60;
  return score == RankScore::reciprocal ? 1 / (rank_constant + static_cast<double>(rank))
                                        : static_cast<double>(models - rank);
}

/// Adds the scores of a row's ranks, from 1 on, for models at a finite distance.
void add_scores(const DistanceMatrix& matrix, Eigen::Index row, double weight, RankScore score, DistanceMatrix& sums) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(matrix.cols()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  order.erase(order.begin() + row);
  std::ranges::stable_sort(order, {}, [&](Eigen::Index column) { return matrix(row, column); });
  Eigen::Index rank = 0;
  for (const Eigen::Index column : order) {
    if (std::isinf(matrix(row, column))) break;  // and all that follow
    sums(row, column) += weight * score_of(++rank, matrix.cols(), score);
  }
}

}  // namespace

void check_sum_weights(std::size_t terms, std::span<const double> weights) {
  if (terms == 0 || terms != weights.size()) {
    throw ArgumentError("distances need at least one matrix and a weight for each to be fused, not " +
                        std::to_string(terms) + " matrices and " + std::to_string(weights.size()) + " weights");
  }
  double total = 0;
  for (const double weight : weights) {
    if (!(weight >= 0) || !std::isfinite(weight)) {
      throw ArgumentError("a weight of fused distances is " + std::to_string(weight) +
                          "; it must be finite and not negative");
    }
    total += weight;
  }
  if (!(total > 0)) throw ArgumentError("at least one weight of fused distances must be positive");
}

double distance_unit(const DistanceMatrix& matrix, DistanceScale scale) {
  const Eigen::Index size = matrix.rows();
  if (scale == DistanceScale::none || size < 2) return 1;
  if (scale == DistanceScale::mean) {
    const double mean = (matrix.sum() - matrix.diagonal().sum()) / static_cast<double>(size * (size - 1));
    if (std::isfinite(mean)) return mean;
  }
  std::vector<double> distances = finite_distances(matrix);
  if (distances.empty()) return 1;
  if (scale == DistanceScale::mean) return overflow_safe_mean(distances);
  return upper_median(distances);
}

DistanceMatrix sum_of_distances(std::span<const DistanceMatrix> matrices, std::span<const double> weights,
                                DistanceScale scale) {
  check(matrices, weights);
  DistanceMatrix sum = DistanceMatrix::Zero(matrices.front().rows(), matrices.front().cols());
  for (std::size_t k = 0; k < matrices.size(); ++k) {
    if (weights[k] == 0) continue;
    if (scale == DistanceScale::local) {
      sum += weights[k] * locally_scaled(matrices[k]);
      continue;
    }
    if (uses_ranks(scale)) {
      add_log_ranks(locally_scaled(matrices[k]), weights[k], sum);
      continue;
    }
    const double unit = distance_unit(matrices[k], scale);
    if (!(unit > 0)) {
      throw ArgumentError("the median or mean of the distances of matrix " + std::to_string(k) +
                          " (counted from 0) is 0; use another scale");
    }
    sum += weights[k] / unit * matrices[k];
  }
  if (!sum.allFinite()) settle_infinite(matrices, weights, sum);
  return sum;
}

std::vector<double> sum_weights(std::span<const DistanceMatrix> matrices, std::span<const double> weights,
                                SumWeights kind) {
  check(matrices, weights);
  if (kind == SumWeights::given) return {weights.begin(), weights.end()};
  return sum_weights(nearest_by_matrix(matrices, weights), weights);
}

int nearest_for_weights() { return neighbour_counts({}).back() + 1; }

std::vector<double> sum_weights(std::span<const NearestModels> nearest, std::span<const double> weights) {
  std::vector<double> found(weights.begin(), weights.end());
  const std::vector<double> factors = agreement_factors(sets_by_matrix(nearest, weights), weights);
  if (std::ranges::all_of(factors, [](double factor) { return factor == 0; })) return found;
  for (std::size_t k = 0; k < found.size(); ++k) found[k] *= factors[k];
  return found;
}

std::optional<Disagreement> find_disagreement(std::span<const DistanceMatrix> matrices,
                                              std::span<const double> weights) {
  check(matrices, weights);
  const std::vector<SetsOfMatrix> sets = sets_by_matrix(nearest_by_matrix(matrices, weights), weights);
  std::vector<double> cohesions;
  for (const SetsOfMatrix& of_matrix : sets) cohesions.push_back(of_matrix.empty() ? 0 : mean_cohesion(of_matrix));
  std::optional<Disagreement> found;
  double least = 0.5;
  for (std::size_t a = 0; a < sets.size(); ++a) {
    for (std::size_t b = a + 1; b < sets.size(); ++b) {
      const double lesser = std::min(cohesions[a], cohesions[b]);
      if (!(lesser > 0)) continue;
      const double common = mean_agreement(sets[a], sets[b]);
      if (common / lesser >= least) continue;
      least = common / lesser;
      found = {.first = a, .second = b, .agreement = common, .cohesion = lesser};
    }
  }
  return found;
}

DistanceMatrix fusion_of_ranks(std::span<const DistanceMatrix> matrices, std::span<const double> weights,
                               RankScore score) {
  check(matrices, weights);
  const Eigen::Index models = matrices.front().rows();
  DistanceMatrix sums = DistanceMatrix::Zero(models, models);
  parallel_for(Eigen::Index{0}, models, [&](Eigen::Index row) {
    for (std::size_t k = 0; k < matrices.size(); ++k) add_scores(matrices[k], row, weights[k], score, sums);
  });
  const double best = std::accumulate(weights.begin(), weights.end(), 0.0) * score_of(1, models, score);
  const DistanceMatrix both = sums + sums.transpose();
  DistanceMatrix fused = 1 - both.array() / (2 * best);
  fused = (both.array() > 0).select(fused, std::numeric_limits<double>::infinity());
  fused.diagonal().setZero();
  return fused.cwiseMax(0);
}

}  // namespace shapegauge
