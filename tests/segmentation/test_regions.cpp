// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <gtest/gtest.h>
#include <set>

#include "shapegauge/segmentation/regions.h"
#include "tests/segmentation/hand_made_surface.h"

namespace shapegauge {
namespace {

TEST(Regions, MergingAddsAreasAndSumsOverPairsOfNodes) {
  Regions regions = test::regions_in_a_row(4);
  regions.add(0, 2, PairSum::pairs, 5);
  regions.add(1, 1, PairSum::pairs, 3);
  regions.merge(1, 2);
  EXPECT_EQ(regions.size(), 3);
  EXPECT_EQ(regions.of(1).area, 2 + 3);
  EXPECT_EQ(regions.of(0, 1, PairSum::pairs), 5);
  EXPECT_EQ(regions.of(1, 1, PairSum::pairs), 6);  // once for each order
  EXPECT_EQ(regions.of(1, 3, PairSum::border), 8);
  EXPECT_EQ(regions.perimeter(1), 2 + 8);
  EXPECT_EQ(regions.neighbours(1), (std::set<std::int32_t>{0, 3}));
  EXPECT_EQ(regions.neighbours(3), (std::set<std::int32_t>{1}));
  EXPECT_EQ(regions.region_of(2), 1);
  regions.merge(0, 1);
  EXPECT_EQ(regions.region_of(2), 0);
  EXPECT_EQ(regions.of(0, 0, PairSum::pairs), 6 + 2 * 5);
  EXPECT_EQ(regions.perimeter(0), 8);
}

/// Distinct sums, proportional to `factor`.
RegionSum different_sums(double factor) {
  RegionSum sum;
  sum.nodes = factor;
  sum.area = 2 * factor;
  sum.thickness = 3 * factor;
  sum.squared_thickness = 4 * factor;
  sum.position = factor * Eigen::Vector3d(5, 6, 7);
  sum.squared_position = factor * Eigen::Vector3d(8, 9, 10).asDiagonal().toDenseMatrix();
  sum.squared_normal = factor * Eigen::Vector3d(11, 12, 13).asDiagonal().toDenseMatrix();
  sum.histogram = factor * Eigen::Array<double, thickness_bins, 1>::LinSpaced(1, thickness_bins);
  return sum;
}

TEST(Regions, MergingAddsEveryQuantityOfTheTwoRegions) {
  Regions regions(2);
  regions.add(0, different_sums(1));
  regions.add(1, different_sums(100));
  regions.merge(0, 1);
  const RegionSum expected = different_sums(101);
  const RegionSum& sum = regions.of(0);
  EXPECT_EQ(sum.nodes, expected.nodes);
  EXPECT_EQ(sum.area, expected.area);
  EXPECT_EQ(sum.thickness, expected.thickness);
  EXPECT_EQ(sum.squared_thickness, expected.squared_thickness);
  EXPECT_EQ(sum.position, expected.position);
  EXPECT_EQ(sum.squared_position, expected.squared_position);
  EXPECT_EQ(sum.squared_normal, expected.squared_normal);
  EXPECT_TRUE(sum.histogram.isApprox(expected.histogram, 1e-15));
}

}  // namespace
}  // namespace shapegauge
