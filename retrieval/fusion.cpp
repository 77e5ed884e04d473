#include "shapegauge/retrieval/fusion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/retrieval/nearest_models.h"

namespace shapegauge {

namespace {

void check(std::span<const DistanceMatrix> matrices, std::span<const double> weights) {
  if (matrices.empty() || matrices.size() != weights.size()) {
    throw ArgumentError("distances need at least one matrix and a weight for each to be fused, not " +
                        std::to_string(matrices.size()) + " matrices and " + std::to_string(weights.size()) +
                        " weights");
  }
  double total = 0;
  for (const double weight : weights) {
    if (!(weight >= 0) || !std::isfinite(weight)) {
      throw ArgumentError("a weight of fused distances is " + std::to_string(weight) +
                          "; it must be finite and not negative");
    }
    total += weight;
  }
  if (!(total > 0)) throw ArgumentError("of the weights of fused distances one at least must be positive");
  const Eigen::Index size = matrices.front().rows();
  for (const DistanceMatrix& matrix : matrices) {
    if (matrix.rows() != size || matrix.cols() != size) {
      throw ArgumentError("fused distance matrices must be square and of one size; there are " + std::to_string(size) +
                          " models and a matrix of " + std::to_string(matrix.rows()) + " x " +
                          std::to_string(matrix.cols()));
    }
    if (size > 0 && !(matrix.minCoeff<Eigen::PropagateNaN>() >= 0)) {
      throw ArgumentError("fused distances must be numbers that are not negative");
    }
  }
}

/// The finite distances between different models.
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

/// Mean of distances whose sum may overflow.
double overflow_safe_mean(const std::vector<double>& distances) {
  const auto count = static_cast<double>(distances.size());
  const double mean = std::accumulate(distances.begin(), distances.end(), 0.0,
                                      [&](double sum, double distance) { return sum + distance / count; });
  return std::min(mean, std::numeric_limits<double>::max());
}

/// Median (of an even number, the greater of the middle two) or mean of the finite distances between different models;
/// 1 where there are none.
double scale_of(const DistanceMatrix& matrix, DistanceScale scale) {
  const Eigen::Index size = matrix.rows();
  if (scale == DistanceScale::none || size < 2) return 1;
  if (scale == DistanceScale::mean) {
    const double mean = (matrix.sum() - matrix.diagonal().sum()) / static_cast<double>(size * (size - 1));
    if (std::isfinite(mean)) return mean;
  }
  std::vector<double> distances = finite_distances(matrix);
  if (distances.empty()) return 1;
  if (scale == DistanceScale::mean) return overflow_safe_mean(distances);
  const auto middle = distances.begin() + std::ssize(distances) / 2;
  std::ranges::nth_element(distances, middle);
  return *middle;
}

/// By model, the mean distance to its ten nearest at a positive finite distance; NaN where there is none.
Eigen::VectorXd mean_distances_to_nearest(const DistanceMatrix& matrix) {
  constexpr std::ptrdiff_t nearest = 10;
  Eigen::VectorXd means(matrix.rows());
  parallel_for(Eigen::Index{0}, matrix.rows(), [&](Eigen::Index i) {
    std::vector<double> distances;
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      if (j != i && matrix(i, j) > 0 && std::isfinite(matrix(i, j))) distances.push_back(matrix(i, j));
    }
    const auto count = std::min(std::ssize(distances), nearest);
    std::ranges::partial_sort(distances, distances.begin() + count);
    distances.resize(static_cast<std::size_t>(count));
    means[i] = count > 0 ? overflow_safe_mean(distances) : std::numeric_limits<double>::quiet_NaN();
  });
  return means;
}

/// By model, the square root of its scale; 1 for a model without positive finite distances, which need none.
Eigen::VectorXd local_scale_roots(const DistanceMatrix& matrix) {
  constexpr double least_share = 0.01;  // of the median
  Eigen::VectorXd scales = mean_distances_to_nearest(matrix);
  std::vector<double> known;
  std::ranges::copy_if(scales, std::back_inserter(known), [](double scale) { return !std::isnan(scale); });
  if (known.empty()) return Eigen::VectorXd::Ones(matrix.rows());
  const auto middle = known.begin() + std::ssize(known) / 2;
  std::ranges::nth_element(known, middle);
  const double least = least_share * *middle;
  return scales.unaryExpr([&](double scale) { return std::isnan(scale) ? 1 : std::sqrt(std::max(scale, least)); });
}

/// sum += weight matrix(i, j) / (roots[i] roots[j])
void add_locally_scaled(const DistanceMatrix& matrix, double weight, DistanceMatrix& sum) {
  const Eigen::VectorXd roots = local_scale_roots(matrix);
  parallel_for(Eigen::Index{0}, matrix.rows(), [&](Eigen::Index i) {
    sum.row(i).array() += weight * (matrix.row(i).array() / (roots[i] * roots.transpose().array()));
  });
}

/// Replaces sums that are not finite: by infinity where a summand is infinite, otherwise by the largest number.
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

/// By model, its five nearest.
using NearestSets = std::vector<std::vector<std::int32_t>>;

constexpr int nearest_that_vote = 5;

/// Those that are nearer than the sixth; without a sixth, all at a finite distance.
NearestSets nearest_sets(const DistanceMatrix& matrix) {
  const NearestModels nearest = nearest_models(matrix.rows(), nearest_that_vote + 1, rows_of(matrix));
  NearestSets sets(static_cast<std::size_t>(matrix.rows()));
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const bool has_sixth = nearest.indices.cols() > nearest_that_vote && nearest.indices(i, nearest_that_vote) >= 0;
    const double limit = has_sixth ? nearest.distances(i, nearest_that_vote) : std::numeric_limits<double>::infinity();
    for (Eigen::Index n = 0; n < nearest.indices.cols() && nearest.distances(i, n) < limit; ++n) {
      sets[static_cast<std::size_t>(i)].push_back(nearest.indices(i, n));
    }
  }
  return sets;
}

/// The number of models that are in the same model's set of both.
double common_models(const NearestSets& a, const NearestSets& b) {
  double common = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (const std::int32_t model : a[i]) common += std::ranges::find(b[i], model) != b[i].end() ? 1 : 0;
  }
  return common;
}

/// The number of models that could be in the sets.
double most_in_sets(const NearestSets& sets) {
  const auto models = static_cast<double>(sets.size());
  return models * std::min<double>(nearest_that_vote, models - 1);
}

/// By matrix; 0 where its weight is.
std::vector<double> agreement_factors(const std::vector<NearestSets>& nearest, std::span<const double> weights) {
  std::vector<double> factors(nearest.size());
  for (std::size_t k = 0; k < nearest.size(); ++k) {
    double common = 0;
    double others = 0;
    for (std::size_t other = 0; other < nearest.size(); ++other) {
      if (other == k || weights[other] == 0 || weights[k] == 0) continue;
      common += weights[other] * common_models(nearest[k], nearest[other]);
      others += weights[other];
    }
    if (common > 0) factors[k] = std::pow(common / (others * most_in_sets(nearest[k])), 2);
  }
  return factors;
}

/// By matrix; 0 without sets.
std::vector<double> clustering_factors(const std::vector<NearestSets>& nearest) {
  std::vector<double> factors(nearest.size());
  for (std::size_t k = 0; k < nearest.size(); ++k) {
    double mutual = 0;
    for (std::size_t i = 0; i < nearest[k].size(); ++i) {
      for (const std::int32_t other : nearest[k][i]) {
        const std::vector<std::int32_t>& theirs = nearest[k][static_cast<std::size_t>(other)];
        mutual += std::ranges::find(theirs, static_cast<std::int32_t>(i)) != theirs.end() ? 1 : 0;
      }
    }
    if (mutual > 0) factors[k] = std::pow(mutual / most_in_sets(nearest[k]), 4);
  }
  return factors;
}

double score_of(Eigen::Index rank, Eigen::Index models, RankScore score) {
  constexpr double rank_constant = 60;
  return score == RankScore::reciprocal ? 1 / (rank_constant + static_cast<double>(rank))
                                        : static_cast<double>(models - rank);
}

/// Adds the scores of a row's ranks, from 1 on, of the models at a finite distance.
void add_scores(const DistanceMatrix& matrix, Eigen::Index row, double weight, RankScore score, DistanceMatrix& sums) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(matrix.cols()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  order.erase(order.begin() + row);
  std::ranges::stable_sort(order, {}, [&](Eigen::Index column) { return matrix(row, column); });
  Eigen::Index rank = 0;
  for (const Eigen::Index column : order) {
    if (std::isinf(matrix(row, column))) break;  // so are all behind it
    sums(row, column) += weight * score_of(++rank, matrix.cols(), score);
  }
}

}  // namespace

DistanceMatrix sum_of_distances(std::span<const DistanceMatrix> matrices, std::span<const double> weights,
                                DistanceScale scale) {
  check(matrices, weights);
  DistanceMatrix sum = DistanceMatrix::Zero(matrices.front().rows(), matrices.front().cols());
  for (std::size_t k = 0; k < matrices.size(); ++k) {
    if (weights[k] == 0) continue;
    if (scale == DistanceScale::local) {
      add_locally_scaled(matrices[k], weights[k], sum);
      continue;
    }
    const double unit = scale_of(matrices[k], scale);
    if (!(unit > 0)) {
      throw ArgumentError("the median or mean of the distances of matrix " + std::to_string(k) +
                          " (counted from 0) is 0: it cannot be divided by it");
    }
    sum += weights[k] / unit * matrices[k];
  }
  if (!sum.allFinite()) settle_infinite(matrices, weights, sum);
  return sum;
}

std::vector<double> sum_weights(std::span<const DistanceMatrix> matrices, std::span<const double> weights,
                                SumWeights kind) {
  check(matrices, weights);
  std::vector<double> found(weights.begin(), weights.end());
  const auto positive = std::ranges::count_if(weights, [](double weight) { return weight > 0; });
  if (kind == SumWeights::given || positive < 2) return found;
  std::vector<NearestSets> nearest(matrices.size());
  for (std::size_t k = 0; k < matrices.size(); ++k) {
    if (weights[k] > 0) nearest[k] = nearest_sets(matrices[k]);
  }
  const std::vector<double> factors =
      kind == SumWeights::agreement ? agreement_factors(nearest, weights) : clustering_factors(nearest);
  if (std::ranges::all_of(factors, [](double factor) { return factor == 0; })) return found;
  for (std::size_t k = 0; k < found.size(); ++k) found[k] *= factors[k];
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
