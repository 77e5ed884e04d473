// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <vector>

#include "shapegauge/retrieval/nearest_models.h"

namespace shapegauge {
namespace {

constexpr double no_distance = std::numeric_limits<double>::infinity();

DistanceMatrix with_a_far_model() {
  return DistanceMatrix{{0, 2, 1, no_distance},
                        {2, 0, 2, no_distance},
                        {1, 2, 0, no_distance},
                        {no_distance, no_distance, no_distance, 0}};
}

TEST(NearestModels, AreSortedWithTiesByIndexAndExcludeInfiniteDistances) {
  const DistanceMatrix matrix = with_a_far_model();
  const NearestModels nearest = nearest_models(4, 2, rows_of(matrix));
  EXPECT_EQ(nearest.indices.row(0), (Eigen::RowVector2i{2, 1}));
  EXPECT_EQ(nearest.indices.row(1), (Eigen::RowVector2i{0, 2}));
  EXPECT_EQ(nearest.indices.row(3), (Eigen::RowVector2i{-1, -1}));
  EXPECT_EQ(nearest.distances.row(2), (Eigen::RowVector2d{1, 2}));
  EXPECT_EQ(nearest.distances(3, 0), no_distance);
  EXPECT_EQ(nearest.largest, 2);
}

TEST(NearestModels, CountIsLimitedToTheNumberOfOtherModels) {
  const DistanceMatrix matrix = with_a_far_model();
  EXPECT_EQ(nearest_models(4, 100, rows_of(matrix)).indices.cols(), 3);
  const DistanceMatrix alone = DistanceMatrix::Zero(1, 1);
  EXPECT_EQ(nearest_models(1, 1, rows_of(alone)).indices.cols(), 0);
}

TEST(NearestModels, RejectZeroNeighboursAndRowsOfWrongLength) {
  DistanceMatrix matrix = with_a_far_model();
  EXPECT_THROW(nearest_models(4, 0, rows_of(matrix)), ArgumentError);
  EXPECT_THROW(nearest_models(3, 1, rows_of(matrix)), ArgumentError) << "rows of another length";
  const DistanceMatrix wide = DistanceMatrix::Zero(2, 3);
  EXPECT_THROW(rows_of(wide), ArgumentError);
}

TEST(NearestModels, ErrorNamesTheRowAndColumnOfAnInvalidDistance) {
  for (const double wrong : {-1.0, std::nan("")}) {
    DistanceMatrix matrix = DistanceMatrix::Ones(300, 300);  // of two blocks
    matrix(270, 3) = wrong;
    try {
      nearest_models(300, 1, rows_of(matrix));
      FAIL() << wrong;
    } catch (const ArgumentError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("row 270, column 3"));
    }
  }
}

TEST(ForEachBlockOfRows, VisitsEachRowOnceInOrder) {
  const DistanceMatrix matrix = DistanceMatrix::Random(600, 600);
  std::vector<Eigen::Index> firsts;
  DistanceMatrix seen(0, 600);
  for_each_block(600, rows_of(matrix), [&](Eigen::Index first, const DistanceMatrix& block) {
    EXPECT_EQ(first, seen.rows());
    seen.conservativeResize(seen.rows() + block.rows(), Eigen::NoChange);
    seen.bottomRows(block.rows()) = block;
  });
  EXPECT_EQ(seen, matrix);
}

TEST(OverflowSafeMean, IsFiniteForHugeDistances) {
  EXPECT_EQ(overflow_safe_mean(std::vector<double>{1, 2, 6}), 3);
  EXPECT_TRUE(std::isnan(overflow_safe_mean({})));
  const double most = std::numeric_limits<double>::max();
  EXPECT_EQ(overflow_safe_mean(std::vector<double>{most, most}), most);
}

TEST(MeanDistance, IsTheMeanOfTheFiniteDistances) {
  EXPECT_EQ(mean_distance(Eigen::RowVectorXd{{1, 2, 6}}), 3);
  EXPECT_EQ(mean_distance(Eigen::RowVectorXd{{1, no_distance, 3}}), 2);
  EXPECT_EQ(mean_distance(Eigen::RowVectorXd(0)), 0);
}

TEST(OverflowSafeFactor, ScalesExtremeDistancesToFiniteSquares) {
  EXPECT_EQ(overflow_safe_factor(1), 1);
  EXPECT_EQ(overflow_safe_factor(0), 1);
  for (const double extreme : {1e300, 1e-300}) {
    const double moved = extreme * overflow_safe_factor(extreme);
    EXPECT_NE(overflow_safe_factor(extreme), 1);
    EXPECT_EQ(moved / overflow_safe_factor(extreme), extreme) << "a power of two";
  }
}

TEST(Symmetrise, AveragesAMatrixWithItsTransposeAndZeroesTheDiagonal) {
  EXPECT_EQ(symmetrise(DistanceMatrix{{5, 1}, {3, 7}}), (DistanceMatrix{{0, 2}, {2, 0}}));
}

}  // namespace
}  // namespace shapegauge
