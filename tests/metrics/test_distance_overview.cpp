// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <utility>
#include <vector>

#include "shapegauge/metrics/distance_overview.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;

DistanceMatrix numbers(Eigen::Index models) {
  DistanceMatrix distances(models, models);
  for (Eigen::Index i = 0; i < models; ++i) {
    for (Eigen::Index j = 0; j < models; ++j) distances(i, j) = 0.1 * static_cast<double>((i * 31 + j * 17) % 101);
  }
  return distances;
}

std::vector<int> labels_of(Eigen::Index models) {
  std::vector<int> labels(static_cast<std::size_t>(models));
  for (std::size_t i = 0; i < labels.size(); ++i) labels[i] = static_cast<int>(i % 7);
  return labels;
}

TEST(OrderByClass, SortsByClassAndKeepsTheOrderWithinClasses) {
  EXPECT_THAT(order_by_class(std::vector<int>{2, 0, 1, 0, 2}), ElementsAre(1, 3, 2, 0, 4));
}

TEST(DistanceOverview, ContainsSingleDistancesForFewModels) {
  DistanceMatrix distances{{9, 1, 2}, {3, 9, 4}, {5, std::numeric_limits<double>::infinity(), 9}};
  const DistanceOverview overview = overview_of(distances, std::vector<int>{1, 0, 0});
  EXPECT_EQ(overview.block, 1);
  EXPECT_EQ(overview.cells, (Eigen::MatrixXd{{0, 4, 3}, {distances(2, 1), 0, 5}, {1, 2, 0}}));
  EXPECT_EQ(overview.nearest, (NearestIndices{{1, 2}, {0, 2}, {0, 1}}));
  EXPECT_EQ(overview.nearest_distances, (DistanceMatrix{{1, 2}, {3, 4}, {5, distances(2, 1)}}));
}

TEST(DistanceOverview, ContainsMeansOfBlocksForManyModels) {
  const Eigen::Index models = 2 * max_heat_map_side - 1;
  DistanceMatrix distances = numbers(models);
  distances(4, 7) = std::numeric_limits<double>::infinity();
  const std::vector<int> labels = labels_of(models);
  const DistanceOverview overview = overview_of(distances, labels);
  ASSERT_EQ(overview.block, 2);
  ASSERT_EQ(overview.cells.rows(), max_heat_map_side);
  const std::vector<Eigen::Index> order = order_by_class(labels);
  for (const Eigen::Index row : {0, 1, 500, 999}) {
    for (Eigen::Index column = 0; column < max_heat_map_side; ++column) {
      double sum = 0;
      int count = 0;
      for (Eigen::Index i = 2 * row; i < std::min(2 * row + 2, models); ++i) {
        for (Eigen::Index j = 2 * column; j < std::min(2 * column + 2, models); ++j) {
          const Eigen::Index a = order[static_cast<std::size_t>(i)];
          const Eigen::Index b = order[static_cast<std::size_t>(j)];
          if (!std::isfinite(distances(a, b))) continue;
          sum += a == b ? 0 : distances(a, b);
          ++count;
        }
      }
      EXPECT_NEAR(overview.cells(row, column), sum / count, 10 * 0x1p-24);  // the rounding to units
    }
  }
}

TEST(DistanceOverview, DoesNotDependOnTheOrderInWhichRowsArrive) {
  for (const Eigen::Index models : {40, 1500}) {
    const DistanceMatrix distances = numbers(models);
    const std::vector<int> labels = labels_of(models);
    const DistanceOverview whole = overview_of(distances, labels);
    OverviewAccumulator seen =
        begin_overview(labels, largest_finite({distances.data(), static_cast<std::size_t>(models)}, 0));
    for (const auto& [first, last] : {std::pair<Eigen::Index, Eigen::Index>{11, 30}, {30, models}, {0, 11}}) {
      accumulate(distances.middleRows(first, last - first), first, seen);
    }
    const DistanceOverview together = overview_of(std::move(seen));
    EXPECT_EQ(together.cells, whole.cells);
    EXPECT_EQ(together.nearest, whole.nearest);
    EXPECT_EQ(together.nearest_distances, whole.nearest_distances);
  }
}

}  // namespace

}  // namespace shapegauge
