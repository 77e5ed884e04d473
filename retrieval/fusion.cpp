#include "shapegauge/retrieval/fusion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel.h"

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
