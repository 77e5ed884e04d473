// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/retrieval/collection_sum.h"

namespace shapegauge {
namespace {

/// Points of a few groups in a plane, with one duplicate.
Eigen::MatrixX2d grouped_points(Eigen::Index count, std::uint64_t seed) {
  RandomNumbers random(seed);
  Eigen::MatrixX2d points(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    points.row(i) << static_cast<double>(i % 4) + random.uniform(0, 0.5), random.uniform(0, 1);
  }
  points.row(count - 1) = points.row(0);
  return points;
}

DistanceMatrix point_distances(const Eigen::MatrixX2d& points, double power) {
  DistanceMatrix matrix(points.rows(), points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    for (Eigen::Index j = 0; j < points.rows(); ++j) {
      matrix(i, j) = std::pow((points.row(i) - points.row(j)).norm(), power);
    }
  }
  return matrix;
}

struct Terms {
  std::vector<DistanceMatrix> matrices;
  std::vector<double> weights = {1, 0.5, 0};

  explicit Terms(const Eigen::MatrixX2d& points) {
    for (const double power : {1.0, 2.0, 0.5}) matrices.push_back(point_distances(points, power));
  }

  [[nodiscard]] CollectionSum sum(SumWeights kind, DistanceScale scale) const {
    std::vector<RowSource> rows;
    for (const DistanceMatrix& matrix : matrices) rows.push_back(rows_of(matrix));
    return collection_sum(matrices.front().rows(), rows, weights, kind, scale);
  }

  [[nodiscard]] std::vector<Eigen::VectorXd> rows_at(Eigen::Index i) const {
    std::vector<Eigen::VectorXd> rows;
    for (const DistanceMatrix& matrix : matrices) rows.emplace_back(matrix.row(i));
    return rows;
  }
};

class CollectionSumOfEachKind : public testing::TestWithParam<std::tuple<SumWeights, DistanceScale>> {};

TEST_P(CollectionSumOfEachKind, RowsEqualTheRowsOfTheSummedMatrices) {
  const auto& [kind, scale] = GetParam();
  const Terms terms(grouped_points(300, 1));  // more rows than one block
  const DistanceMatrix whole =
      sum_of_distances(terms.matrices, sum_weights(terms.matrices, terms.weights, kind), scale);
  const CollectionSum sum = terms.sum(kind, scale);
  for (Eigen::Index i = 0; i < whole.rows(); ++i)
    EXPECT_EQ(sum_row(sum, terms.rows_at(i), i), whole.row(i).transpose());
}

INSTANTIATE_TEST_SUITE_P(All, CollectionSumOfEachKind,
                         testing::Combine(testing::Values(SumWeights::given, SumWeights::agreement),
                                          testing::Values(DistanceScale::none, DistanceScale::median,
                                                          DistanceScale::mean, DistanceScale::local,
                                                          DistanceScale::ranks)));

TEST(CollectionSum, QueryEqualToAModelHasTheDistancesOfThatModel) {
  const Terms terms(grouped_points(80, 2));
  for (const DistanceScale scale : {DistanceScale::local, DistanceScale::ranks}) {
    const CollectionSum sum = terms.sum(SumWeights::agreement, scale);
    for (const Eigen::Index i : {0, 7, 79}) {
      EXPECT_EQ(sum_row(sum, terms.rows_at(i)), sum_row(sum, terms.rows_at(i), i)) << i;
    }
  }
}

TEST(CollectionSum, DividesQueryDistancesByTheLocalScalesOfQueryAndModel) {
  const std::vector matrices = {point_distances(grouped_points(30, 3), 1)};
  const std::vector<RowSource> rows{rows_of(matrices.front())};
  const std::vector<double> one = {1};
  const CollectionSum sum = collection_sum(30, rows, one, SumWeights::given, DistanceScale::local);
  Eigen::VectorXd distances = Eigen::VectorXd::LinSpaced(30, 1, 30);  // ten nearest: 1 to 10
  const std::vector query = {distances};
  const Eigen::VectorXd row = sum_row(sum, query);
  for (Eigen::Index j = 0; j < 30; ++j) {
    EXPECT_NEAR(row[j], distances[j] / (std::sqrt(5.5) * sum.local_scales.front().roots[j]), 1e-12);
  }
  // Ten times as far from all: locally scaled distances grow by sqrt 10.
  const std::vector farther = {Eigen::VectorXd(100 * distances)};
  EXPECT_TRUE(sum_row(sum, farther).isApprox(10 * row, 1e-12));
}

TEST(CollectionSum, LocalScaleOfAQueryHasAPositiveLowerLimit) {
  const std::vector matrices = {point_distances(grouped_points(30, 4), 1)};
  const std::vector<RowSource> rows{rows_of(matrices.front())};
  const CollectionSum sum = collection_sum(30, rows, std::vector<double>{1}, SumWeights::given, DistanceScale::local);
  const LocalScales& scales = sum.local_scales.front();
  EXPECT_EQ(scales.root_of(0.5 * scales.least), std::sqrt(scales.least));
  EXPECT_GT(scales.least, 0);
}

TEST(CollectionSum, RejectsInvalidWeightsAndMatricesOfOnlyZeros) {
  const Terms terms(grouped_points(20, 5));
  std::vector<RowSource> rows;
  for (const DistanceMatrix& matrix : terms.matrices) rows.push_back(rows_of(matrix));
  const auto sum = [&](const std::vector<double>& weights) {
    return collection_sum(20, rows, weights, SumWeights::given, DistanceScale::median);
  };
  EXPECT_THROW(sum({1, 1}), ArgumentError);
  EXPECT_THROW(sum({0, 0, 0}), ArgumentError);
  EXPECT_THROW(sum({1, 1, -1}), ArgumentError);
  const DistanceMatrix zero = DistanceMatrix::Zero(20, 20);
  rows.front() = rows_of(zero);
  EXPECT_THROW(sum({1, 1, 1}), ArgumentError);
  EXPECT_NO_THROW(sum({0, 1, 1}));
}

}  // namespace
}  // namespace shapegauge
