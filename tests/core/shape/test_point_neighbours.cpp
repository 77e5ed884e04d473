#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "shapegauge/core/shape/point_neighbours.h"
#include "shapegauge/random/random_numbers.h"

namespace shapegauge {
namespace {

TEST(PointNeighbours, AreThoseThatAllDistancesGive) {
  RandomNumbers random(5);
  Points points(200, 3);
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] = random.uniform(-1, 1);
  constexpr Eigen::Index k = 7;
  const PointNeighbours found = nearest_neighbours(points, k);
  ASSERT_EQ(found.indices.rows(), 200);
  ASSERT_EQ(found.indices.cols(), k);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    std::vector<std::pair<double, std::int32_t>> all;
    for (Eigen::Index j = 0; j < points.rows(); ++j) {
      if (j != i) all.emplace_back((points.row(j) - points.row(i)).norm(), static_cast<std::int32_t>(j));
    }
    std::ranges::sort(all);
    for (Eigen::Index m = 0; m < k; ++m) {
      EXPECT_EQ(found.indices(i, m), all[static_cast<std::size_t>(m)].second);
      EXPECT_DOUBLE_EQ(found.distances(i, m), all[static_cast<std::size_t>(m)].first);
    }
  }
}

TEST(PointNeighbours, PointsAtTheSamePlaceAreNeighbours) {
  Points points = Points::Zero(100, 3);
  points.row(99) << 3, 4, 0;
  const PointNeighbours found = nearest_neighbours(points, 4);
  for (Eigen::Index i = 0; i < 100; ++i) {
    EXPECT_EQ(found.distances.row(i), Eigen::RowVector4d::Constant(i == 99 ? 5 : 0));
    for (const std::int32_t j : found.indices.row(i)) EXPECT_NE(j, i);
  }
}

TEST(PointNeighbours, NoMoreThanThereAre) {
  Points points(3, 3);
  points << 0, 0, 0, 1, 0, 0, 5, 0, 0;
  const PointNeighbours found = nearest_neighbours(points, 8);
  EXPECT_EQ(found.indices.cols(), 2);
  EXPECT_EQ(found.distances, (Eigen::Matrix<double, 3, 2>() << 1, 5, 1, 4, 4, 5).finished());
  EXPECT_EQ(nearest_neighbours(points.topRows(1), 8).indices.cols(), 0);
  EXPECT_EQ(nearest_neighbours(Points(0, 3), 8).indices.rows(), 0);
}

}  // namespace
}  // namespace shapegauge
