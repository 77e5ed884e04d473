// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

#include "shapegauge/core/spatial/morton_order.h"

namespace shapegauge {

namespace {

double length_of_way(const Points& points, const std::vector<std::int32_t>& order) {
  double length = 0;
  for (std::size_t i = 1; i < order.size(); ++i) length += (points.row(order[i]) - points.row(order[i - 1])).norm();
  return length;
}

TEST(MortonOrder, VisitsEachPointOnceOnAShortPath) {
  const Points points = Points::Random(4000, 3);
  std::vector<std::int32_t> order = morton_order(points);
  std::vector<std::int32_t> input_order(order.size());
  std::iota(input_order.begin(), input_order.end(), 0);
  EXPECT_LT(length_of_way(points, order), 0.2 * length_of_way(points, input_order));
  std::sort(order.begin(), order.end());
  EXPECT_EQ(order, input_order);
}

TEST(MortonOrder, KeepsTheOrderOfCoincidentPoints) {
  EXPECT_EQ(morton_order(Points::Ones(3, 3)), (std::vector<std::int32_t>{0, 1, 2}));
  EXPECT_TRUE(morton_order(Points(0, 3)).empty());
}

}  // namespace

}  // namespace shapegauge
