// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "shapegauge/retrieval/local_scales.h"

namespace shapegauge {
namespace {

TEST(MeanDistanceToNearest, UsesTheTenNearestByDefault) {
  std::vector<double> distances{50};
  for (int i = 12; i > 0; --i) distances.push_back(i);
  EXPECT_DOUBLE_EQ(mean_distance_to_nearest(distances), 5.5);
  EXPECT_DOUBLE_EQ(mean_distance_to_nearest(distances, 12), 6.5) << "without the entry of 1";
}

TEST(MeanDistanceToNearest, IgnoresDuplicatesAndInfiniteDistances) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(mean_distance_to_nearest(std::vector<double>{0, 2, infinity, 4}), 3);
  EXPECT_TRUE(std::isnan(mean_distance_to_nearest(std::vector<double>{0, infinity})));
}

TEST(LocalScales, AreSquareRootsOfMeanDistancesWithALowerLimit) {
  const LocalScales scales = LocalScales::of_means(Eigen::VectorXd{{4, 100, 0.01, std::nan(""), 900}});
  EXPECT_EQ(scales.least, 1) << "of the upper median, 100";
  EXPECT_EQ(scales.roots, (Eigen::VectorXd{{2, 10, 1, 1, 30}}));
  EXPECT_EQ(scales.root_of(0.5), 1);
  EXPECT_EQ(scales.root_of(16), 4);
}

}  // namespace
}  // namespace shapegauge
