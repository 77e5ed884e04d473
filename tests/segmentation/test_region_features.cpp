// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <string_view>

#include "shapegauge/segmentation/patches.h"
#include "shapegauge/segmentation/region_features.h"
#include "shapegauge/segmentation/regions.h"
#include "shapegauge/segmentation/surface_regions.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

TEST(RegionFeatures, HaveUniqueNames) {
  const auto& names = region_feature_names();
  EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size());
  EXPECT_FALSE(names.back().empty());
}

/// A region with standard deviations 0.1, 0.2 and 0.4 along the axes, times `size`, about a position.
RegionSum formed_region(double area, double size, const Eigen::Vector3d& position) {
  RegionSum sum;
  sum.area = area;
  sum.position = area * position;
  const Eigen::Matrix3d covariance = size * size * Eigen::Vector3d(0.01, 0.04, 0.16).asDiagonal().toDenseMatrix();
  sum.squared_position = area * (covariance + position * position.transpose());
  return sum;
}

/// Two regions with distinct sums, the first of them larger, and a third adjacent to both.
Regions hand_made_regions() {
  Regions regions(3);
  RegionSum large = formed_region(0.5, 1, {0, 0, 0});
  large.thickness = 0.5 * -1.5;
  large.squared_thickness = 0.5 * (1.5 * 1.5 + 0.3 * 0.3);
  large.squared_normal = 0.5 * Eigen::Vector3d(0.2, 0.3, 0.5).asDiagonal().toDenseMatrix();
  large.histogram[20] = 0.5;
  RegionSum small = formed_region(0.2, 0.5, {0, 0, 0.7});
  small.thickness = 0.2 * -2.5;
  small.squared_thickness = 0.2 * (2.5 * 2.5 + 0.1 * 0.1);
  small.squared_normal = 0.2 * Eigen::Vector3d(0.1, 0.1, 0.8).asDiagonal().toDenseMatrix();
  small.histogram[13] = 0.15;
  small.histogram[16] = 0.05;
  regions.add(0, large);
  regions.add(1, small);
  regions.add(0, 1, PairSum::pairs, 0.1);
  regions.add(0, 1, PairSum::seen_shallow, 0.02);
  regions.add(0, 1, PairSum::seen_deep, 0.03);
  regions.add(0, 1, PairSum::seen_outside, 0.04);
  regions.add(0, 0, PairSum::pairs, 0.125);  // twice that: once for each order
  regions.add(0, 0, PairSum::seen_shallow, 0.1);
  regions.add(0, 0, PairSum::seen_deep, 0.05);
  regions.add(0, 0, PairSum::seen_outside, 0.0125);
  regions.add(1, 1, PairSum::pairs, 0.02);
  regions.add(1, 1, PairSum::seen_shallow, 0.014);
  regions.add(1, 1, PairSum::seen_deep, 0.012);
  regions.add(1, 1, PairSum::seen_outside, 0.001);
  regions.add(0, 1, PairSum::opposite, 0.03);
  regions.add(0, 0, PairSum::opposite, 0.2);
  regions.add(1, 1, PairSum::opposite, 0.05);
  regions.add(0, 1, PairSum::near_pairs, 0.01);
  regions.add(0, 1, PairSum::near_tilt, 0.002);
  regions.add(0, 1, PairSum::wide_pairs, 0.04);
  regions.add(0, 1, PairSum::wide_tilt, -0.006);
  regions.add(0, 1, PairSum::border, 0.6);
  regions.add(0, 1, PairSum::concave, 0.3);
  regions.add(0, 1, PairSum::convex, 0.06);
  regions.add(0, 1, PairSum::folded, 0.15);
  regions.add(0, 1, PairSum::thickness, 0.6 * -2.2);
  regions.add(0, 2, PairSum::border, 1.4);
  regions.add(1, 2, PairSum::border, 0.2);
  return regions;
}

TEST(RegionFeatures, MatchHandComputedValuesForTwoRegions) {
  const double bin = -std::log(0.005) / 32;
  // Of both together: the mean position is at 2/7 of the way to the small one, 0.7 away.
  const double along = (0.5 * 0.16 + 0.2 * 0.04) / 0.7 + 0.7 * 0.7 * (5.0 / 7) * (2.0 / 7);
  const double across = (0.5 * 0.04 + 0.2 * 0.01) / 0.7;
  const double least = (0.5 * 0.01 + 0.2 * 0.0025) / 0.7;
  const std::map<std::string, double> expected = {
      {"seen shallow", 0.2},
      {"seen deep", 0.3},
      {"own seen shallow", 0.7},
      {"own seen deep", 0.4},
      {"seen shallow / own", 0.2 / 0.7},
      {"seen deep / own", 0.3 / 0.4},
      {"seen outside", 0.4},
      {"small seen outside", 0.05},
      {"large seen outside", 0.1},
      {"thickness apart", 1},
      {"thickness small - large", -1},
      {"thickness moved", (0.75 * 7 + 0.25 * 4) * bin},
      {"thickness spread", 0.3},
      {"thickness small", -2.5},
      {"thickness / size small", -2.5 - std::log(0.2) / 2},
      {"thickness / size large", -1.5 - std::log(0.5) / 2},
      {"border thickness - least", 0.3},
      {"border thickness - most", -0.7},
      {"border / girth", std::log(0.6 / (std::numbers::pi * std::exp(-2.2)))},
      {"border concave", 0.5},
      {"border convex", 0.1},
      {"border folded", 0.25},
      {"tilt near", 0.2},
      {"tilt wide", -0.15},
      {"border / size", std::log(0.6 / std::sqrt(0.2))},
      {"border / least perimeter", 0.6 / 0.8},
      {"border / most perimeter", 0.6 / 2.0},
      {"opposite", 0.03 / 0.2},
      {"own opposite small", 0.1 / 0.2},
      {"own opposite large", 0.4 / 0.5},
      {"own opposite both", (0.1 + 0.4 + 2 * 0.03) / 0.7},
      {"elongation small", std::log(2)},
      {"elongation large", std::log(2)},
      {"elongation both", std::log(along / across) / 2},
      {"flatness small", std::log(2)},
      {"flatness large", std::log(2)},
      {"flatness both", std::log(across / least) / 2},
      {"one normal small", 0.8},
      {"one normal large", 0.5},
      {"one normal both", (0.5 * 0.5 + 0.2 * 0.8) / 0.7},
      {"distance", 0.7},
      {"area small", std::log(0.2)},
      {"area large", std::log(0.5)},
      {"regions", std::log(3)},
  };
  const RegionFeatures features = features_of(hand_made_regions(), 0, 1);
  ASSERT_EQ(expected.size(), region_feature_names().size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const std::string name(region_feature_names()[k]);
    ASSERT_TRUE(expected.contains(name)) << name;
    EXPECT_NEAR(features[static_cast<Eigen::Index>(k)], expected.at(name), 1e-7) << name;
  }
  EXPECT_EQ(features_of(hand_made_regions(), 1, 0), features);
}

TEST(RegionFeatures, TreatRegionsWithoutPairsOfNodesAsConvex) {
  const RegionFeatures features = features_of(Regions(2), 0, 1);
  const auto value = [&](std::string_view name) {
    const auto& names = region_feature_names();
    return features[std::ranges::find(names, name) - names.begin()];
  };
  EXPECT_EQ(value("seen deep"), 1);
  EXPECT_EQ(value("own seen shallow"), 1);
  EXPECT_EQ(value("tilt near"), -0.3);
  EXPECT_EQ(value("tilt wide"), -0.3);
  EXPECT_EQ(value("area small"), std::log(1e-9));
}

TEST(RegionFeatures, AreSymmetricInTheTwoRegions) {
  const ThickSurface surface = thick_surface(test::box({1, 2, 3}, 6));
  const Regions regions = surface_regions(surface, patches(surface.graph, {.count = 12}, patch_costs(surface)), 300);
  for (const std::int32_t b : regions.neighbours(0)) EXPECT_EQ(features_of(regions, 0, b), features_of(regions, b, 0));
}

TEST(RegionFeatures, AreFiniteForEmptyRegions) { EXPECT_TRUE(features_of(Regions(2), 0, 1).allFinite()); }

}  // namespace
}  // namespace shapegauge
