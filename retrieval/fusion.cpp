#include "shapegauge/retrieval/fusion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>

#include "shapegauge/core/base/parallel.h"

namespace shapegauge {

namespace {

void check(std::span<const DistanceMatrix> matrices, std::span<const double> weights) {
  if (matrices.empty() || matrices.size() != weights.size()) {
    throw std::invalid_argument("distances need at least one matrix and a weight for each to be fused, not " +
                                std::to_string(matrices.size()) + " matrices and " + std::to_string(weights.size()) +
                                " weights");
  }
  double total = 0;
  for (const double weight : weights) {
    if (!(weight >= 0) || !std::isfinite(weight)) {
      throw std::invalid_argument("a weight of fused distances is " + std::to_string(weight) +
                                  "; it must be finite and not negative");
    }
    total += weight;
  }
  if (!(total > 0)) throw std::invalid_argument("of the weights of fused distances one at least must be positive");
  const Eigen::Index size = matrices.front().rows();
  for (const DistanceMatrix& matrix : matrices) {
    if (matrix.rows() != size || matrix.cols() != size) {
      throw std::invalid_argument("fused distance matrices must be square and of one size; there are " +
                                  std::to_string(size) + " models and a matrix of " + std::to_string(matrix.rows()) +
                                  " x " + std::to_string(matrix.cols()));
    }
    if (size > 0 && !(matrix.minCoeff<Eigen::PropagateNaN>() >= 0 && std::isfinite(matrix.maxCoeff()))) {
      throw std::invalid_argument("fused distances must be finite and not negative");
    }
  }
}

/// Median (of an even number, the greater of the middle two) or mean of the distances between different models.
double scale_of(const DistanceMatrix& matrix, DistanceScale scale) {
  const Eigen::Index size = matrix.rows();
  if (scale == DistanceScale::none || size < 2) return 1;
  if (scale == DistanceScale::mean) {
    return (matrix.sum() - matrix.diagonal().sum()) / static_cast<double>(size * (size - 1));
  }
  std::vector<double> distances;
  distances.reserve(static_cast<std::size_t>(size * (size - 1)));
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j) {
      if (i != j) distances.push_back(matrix(i, j));
    }
  }
  const auto middle = distances.begin() + std::ssize(distances) / 2;
  std::ranges::nth_element(distances, middle);
  return *middle;
}

double score_of(Eigen::Index rank, Eigen::Index models, RankScore score) {
  constexpr double rank_constant = 60;
  return score == RankScore::reciprocal ? 1 / (rank_constant + static_cast<double>(rank))
                                        : static_cast<double>(models - rank);
}

/// Adds the scores of a row's ranks, from 1 on.
void add_scores(const DistanceMatrix& matrix, Eigen::Index row, double weight, RankScore score, DistanceMatrix& sums) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(matrix.cols()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  order.erase(order.begin() + row);
  std::ranges::stable_sort(order, {}, [&](Eigen::Index column) { return matrix(row, column); });
  Eigen::Index rank = 0;
  for (const Eigen::Index column : order) {
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
      throw std::invalid_argument("the median or mean of the distances of matrix " + std::to_string(k) +
                                  " (counted from 0) is 0: it cannot be divided by it");
    }
    sum += weights[k] / unit * matrices[k];
  }
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
  DistanceMatrix fused = 1 - (sums + sums.transpose()).array() / (2 * best);
  fused.diagonal().setZero();
  return fused.cwiseMax(0);
}

}  // namespace shapegauge
