// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/retrieval/mutual_ranks.h"

namespace shapegauge {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

DistanceMatrix uniform_distances(Eigen::Index size, std::uint64_t seed) {
  RandomNumbers random(seed);
  DistanceMatrix matrix = DistanceMatrix::Zero(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) matrix(i, j) = matrix(j, i) = random.uniform(0, 1);
  }
  return matrix;
}

DistanceMatrix log_ranks(const DistanceMatrix& matrix) {
  const auto row = [&](Eigen::Index i) {
    return std::span(matrix.row(i).data(), static_cast<std::size_t>(matrix.cols()));
  };
  DistanceMatrix at_ranks(matrix.rows(), sampled_rank_count(matrix.rows()));
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) at_ranks.row(i) = distances_at_ranks(row(i), i);
  DistanceMatrix found(matrix.rows(), matrix.cols());
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) found.row(i) = log_mutual_ranks(row(i), at_ranks.row(i), at_ranks);
  return found;
}

/// Number of models at a positive distance of at most matrix(i, j). A plain loop: it runs millions of times
/// unoptimised.
double literal_rank(const DistanceMatrix& matrix, Eigen::Index i, Eigen::Index j) {
  const double* const row = matrix.row(i).data();
  const double limit = row[j];
  int rank = 0;
  for (Eigen::Index other = 0, count = matrix.cols(); other < count; ++other) {
    if (row[other] > 0 && row[other] <= limit) ++rank;
  }
  return rank;
}

double literal(const DistanceMatrix& matrix, Eigen::Index i, Eigen::Index j) {
  if (std::isinf(matrix(i, j))) return infinite;
  return std::log1p((literal_rank(matrix, i, j) + literal_rank(matrix, j, i)) / 2);
}

TEST(MutualRanks, AreExactForFewModels) {
  DistanceMatrix matrix = uniform_distances(33, 1);
  matrix(3, 8) = matrix(8, 3) = 0;         // duplicates
  matrix(5, 9) = matrix(9, 5) = infinite;  // unreachable
  matrix(2, 6) = matrix(6, 2) = matrix(2, 7) = matrix(7, 2) = 0.5;
  const DistanceMatrix found = log_ranks(matrix);
  for (Eigen::Index i = 0; i < 33; ++i) {
    for (Eigen::Index j = 0; j < 33; ++j) EXPECT_EQ(found(i, j), literal(matrix, i, j)) << i << ' ' << j;
  }
}

TEST(MutualRanks, LogarithmsErrByAtMostASixteenthForManyModels) {
  const DistanceMatrix matrix = uniform_distances(500, 2);
  const DistanceMatrix found = log_ranks(matrix);
  for (Eigen::Index i = 0; i < 500; ++i) {
    for (Eigen::Index j = 0; j < 500; ++j) EXPECT_NEAR(found(i, j), literal(matrix, i, j), 1.0 / 16);
  }
}

TEST(MutualRanks, DependOnlyOnTheOrderOfDistances) {
  const DistanceMatrix matrix = uniform_distances(33, 3);
  EXPECT_EQ(log_ranks(matrix.cwiseAbs2()), log_ranks(matrix));
  EXPECT_EQ(log_ranks(1e300 * matrix.cwiseSqrt()), log_ranks(matrix));
}

TEST(MutualRanks, AreBelowOneForAQueryCloserThanTheNearestModel) {
  const std::vector<double> line{0, 2, 4};
  const Eigen::RowVectorXd at_ranks = distances_at_ranks(line, 0);
  EXPECT_EQ(at_ranks, (Eigen::RowVectorXd{{2, 4}}));
  const std::vector<double> query{1, 3, 9};
  const Eigen::RowVectorXd found = log_mutual_ranks(query, at_ranks, at_ranks.replicate(3, 1));
  const Eigen::RowVectorXd expected{{std::log1p(0.5), std::log1p(1.5), std::log1p(2)}};
  EXPECT_LE((found - expected).cwiseAbs().maxCoeff(), 1e-15);
}

}  // namespace
}  // namespace shapegauge
