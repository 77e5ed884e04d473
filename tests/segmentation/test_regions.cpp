#include <algorithm>
#include <cmath>
#include <cstddef>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <rapidcheck/gtest.h>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/segmentation/patches.h"
#include "shapegauge/segmentation/region_features.h"
#include "shapegauge/segmentation/regions.h"
#include "shapegauge/segmentation/surface_regions.h"
#include "tests/segmentation/hand_made_surface.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

TEST(Regions, MergingAddsUp) {
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
  sum.place = factor * Eigen::Vector3d(5, 6, 7);
  sum.squared_place = factor * Eigen::Vector3d(8, 9, 10).asDiagonal().toDenseMatrix();
  sum.squared_normal = factor * Eigen::Vector3d(11, 12, 13).asDiagonal().toDenseMatrix();
  sum.histogram = factor * Eigen::Array<double, thickness_bins, 1>::LinSpaced(1, thickness_bins);
  return sum;
}

TEST(Regions, MergingAddsEverySum) {
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
  EXPECT_EQ(sum.place, expected.place);
  EXPECT_EQ(sum.squared_place, expected.squared_place);
  EXPECT_EQ(sum.squared_normal, expected.squared_normal);
  EXPECT_TRUE(sum.histogram.isApprox(expected.histogram, 1e-15));
}

TEST(RegionFeatures, HaveNamesOfTheirOwn) {
  const auto& names = region_feature_names();
  EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size());
  EXPECT_FALSE(names.back().empty());
}

/// A region with standard deviations 0.1, 0.2 and 0.4 along the axes, times `size`, about a place.
RegionSum formed_region(double area, double size, const Eigen::Vector3d& place) {
  RegionSum sum;
  sum.area = area;
  sum.place = area * place;
  const Eigen::Matrix3d covariance = size * size * Eigen::Vector3d(0.01, 0.04, 0.16).asDiagonal().toDenseMatrix();
  sum.squared_place = area * (covariance + place * place.transpose());
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

TEST(RegionFeatures, OfTwoRegionsByHand) {
  const double bin = -std::log(0.005) / 32;
  // Of both together: the mean place is at 2/7 of the way to the small one, 0.7 away.
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

TEST(RegionFeatures, OfRegionsWithoutPairsAreThoseOfConvexOnes) {
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

Regions regions_of(const Shape& shape, int count) {
  const ThickSurface surface = thick_surface(shape);
  return surface_regions(surface, patches(surface.graph, {.count = count}, patch_costs(surface)), 300);
}

TEST(RegionFeatures, AreTheSameForEitherOrder) {
  const Regions regions = regions_of(test::box({1, 2, 3}, 6), 12);
  for (const std::int32_t b : regions.neighbours(0)) EXPECT_EQ(features_of(regions, 0, b), features_of(regions, b, 0));
}

TEST(RegionFeatures, AreFiniteForRegionsOfWhichNothingIsKnown) {
  EXPECT_TRUE(features_of(Regions(2), 0, 1).allFinite());
}

TEST(SurfaceRegions, OfAConvexShapeSeeEachOtherInsideAndNotOutside) {
  const ThickSurface surface = thick_surface(test::box({4, 1, 1}, 8));
  std::vector<std::int32_t> halves;
  for (std::int32_t i = 0; i < surface.graph.size(); ++i) halves.push_back(surface.graph.samples.points(i, 0) > 0);
  const Regions regions = surface_regions(surface, halves, 200);
  EXPECT_NEAR(regions.of(0).area, 0.5, 1e-9);
  EXPECT_EQ(regions.of(0, 1, PairSum::seen_shallow), regions.of(0, 1, PairSum::pairs));
  EXPECT_EQ(regions.of(0, 1, PairSum::seen_deep), regions.of(0, 1, PairSum::pairs));
  EXPECT_EQ(regions.of(0, 1, PairSum::seen_outside), 0);
  EXPECT_EQ(regions.of(0, 1, PairSum::concave), 0);
  EXPECT_NEAR(regions.of(0, 1, PairSum::border), 4 / std::sqrt(18.0), 1e-6);
  // Triangles opposite to each other are on the same half; only the ends, 2 of 18, face each other,
  // and the two orders share them.
  EXPECT_NEAR(regions.of(0, 1, PairSum::opposite), 1.0 / 18, 1e-6);
}

/// Labels of the triangles of a shape by a function of their centroids.
template <typename Label>
std::vector<std::int32_t> labelled(const ThickSurface& surface, Label label) {
  std::vector<std::int32_t> labels;
  for (std::int32_t i = 0; i < surface.graph.size(); ++i) labels.push_back(label(surface.graph.samples.points.row(i)));
  return labels;
}

TEST(SurfaceRegions, SeeEachOtherOutsideAcrossAConcavity) {
  // Two cubes of side 1 with a gap of 0.5: the facing sides against the rest.
  const Shape right = test::transformed(test::box({1, 1, 1}, 3), 1, Eigen::Matrix3d::Identity(), {1.5, 0, 0});
  const ThickSurface surface = thick_surface(test::joined({test::box({1, 1, 1}, 3), right}));
  const double middle = surface.graph.samples.points.col(0).mean();
  const std::vector<std::int32_t> labels = labelled(surface, [&](const Eigen::RowVector3d& place) {
    const double side = place.x() - middle;
    return std::abs(std::abs(side) - 0.25) > 1e-9 ? 2 : side < 0 ? 0 : 1;
  });
  const Regions regions = surface_regions(surface, labels, 400);
  EXPECT_NEAR(regions.of(0).area, 1.0 / 12, 1e-12);
  EXPECT_NEAR(regions.of(0, 1, PairSum::pairs), 1.0 / 144, 1e-12);
  EXPECT_EQ(regions.of(0, 1, PairSum::seen_outside), regions.of(0, 1, PairSum::pairs));
  EXPECT_EQ(regions.of(0, 1, PairSum::seen_deep), 0);
  EXPECT_EQ(regions.of(0, 1, PairSum::seen_shallow), 0);
  EXPECT_EQ(regions.of(0, 2, PairSum::seen_outside), 0);
  EXPECT_EQ(regions.of(0, 0, PairSum::seen_outside), 0);
  EXPECT_GT(regions.of(0, 2, PairSum::seen_deep), 0);
}

TEST(SurfaceRegions, BordersHaveLengthTurnAndThickness) {
  // The top of a box against the rest: a border of length 4, right angles, of which 1.5 radians count.
  ThickSurface surface = thick_surface(test::box({1, 1, 1}, 6));
  const double top = surface.graph.samples.points.col(2).maxCoeff();
  const std::vector<std::int32_t> labels =
      labelled(surface, [&](const Eigen::RowVector3d& place) { return place.z() > top - 1e-9 ? 1 : 0; });
  for (std::int32_t i = 0; i < surface.graph.size(); ++i) {
    surface.log_thickness[i] = labels[static_cast<std::size_t>(i)] == 1 ? -1 : -3;
  }
  const double border = 4 / std::sqrt(6);
  Regions regions = surface_regions(surface, labels, 10);
  EXPECT_NEAR(regions.of(0, 1, PairSum::border), border, 1e-9);
  EXPECT_NEAR(regions.of(0, 1, PairSum::convex), 1.5 * border, 1e-9);
  EXPECT_EQ(regions.of(0, 1, PairSum::concave), 0);
  EXPECT_EQ(regions.of(0, 1, PairSum::folded), 0);
  EXPECT_NEAR(regions.of(0, 1, PairSum::thickness), -2 * border, 1e-9);
  surface.smooth_normals *= -1;  // seen from the other side the edges are concave
  regions = surface_regions(surface, labels, 10);
  EXPECT_NEAR(regions.of(0, 1, PairSum::concave), 1.5 * border, 1e-9);
  EXPECT_EQ(regions.of(0, 1, PairSum::convex), 0);
  EXPECT_NEAR(regions.of(0, 1, PairSum::folded), border, 1e-9);
}

TEST(SurfaceRegions, NodesAreSummedByArea) {
  ThickSurface surface = thick_surface(test::box({1, 1, 1}, 4));
  const double top = surface.graph.samples.points.col(2).maxCoeff();
  const std::vector<std::int32_t> labels =
      labelled(surface, [&](const Eigen::RowVector3d& place) { return place.z() > top - 1e-9 ? 1 : 0; });
  const double bin = -std::log(0.005) / 32;
  surface.log_thickness.setConstant(std::log(0.005) + 7.5 * bin);
  surface.log_thickness[0] = 1;  // beyond the last bin
  const bool first_at_top = labels[0] == 1;
  const Regions regions = surface_regions(surface, labels, 10);
  const RegionSum& sum = regions.of(first_at_top ? 0 : 1);
  const double area = first_at_top ? 5.0 / 6 : 1.0 / 6;
  const double thickness = surface.log_thickness[1];
  EXPECT_NEAR(sum.area, area, 1e-12);
  EXPECT_NEAR(sum.thickness, area * thickness, 1e-12);
  EXPECT_NEAR(sum.squared_thickness, area * thickness * thickness, 1e-12);
  EXPECT_NEAR(sum.histogram[7], area, 1e-12);
  const double one = surface.graph.samples.weights[0] / 6;
  EXPECT_NEAR(regions.of(first_at_top ? 1 : 0).histogram[31], one, 1e-12);
  EXPECT_EQ(regions.of(1).nodes, 2 * 4 * 4);
  const double half = 0.5 / std::sqrt(6);
  const RegionSum& of_top = regions.of(1);
  EXPECT_TRUE((of_top.place / of_top.area).isApprox(Eigen::Vector3d(0, 0, half), 1e-9));
  EXPECT_NEAR(of_top.squared_place(2, 2) / of_top.area, half * half, 1e-12);
  EXPECT_NEAR(of_top.squared_normal(2, 2), of_top.area, 1e-12);
  EXPECT_NEAR(of_top.squared_normal(0, 0), 0, 1e-12);
}

TEST(SurfaceRegions, TiltIsOfPairsThatAreNearEnough) {
  // Regions of one triangle each, on the top of a cube of 2.45 units and around its edge.
  ThickSurface surface = thick_surface(test::box({1, 1, 1}, 8));
  std::vector<std::int32_t> labels(static_cast<std::size_t>(surface.graph.size()), -1);
  const Points& points = surface.graph.samples.points;
  const double unit = std::sqrt(6);
  labels[0] = 0;
  std::int32_t near = -1;  // just nearer than 0.1 units; than 0.25; and just farther than each
  std::int32_t beyond = -1;
  std::int32_t wide = -1;
  std::int32_t far = -1;
  for (std::int32_t i = 1; i < surface.graph.size(); ++i) {
    const double distance = (points.row(i) - points.row(0)).norm() / unit;
    if (distance > 0.06 && distance < 0.095) near = i;
    if (distance > 0.105 && distance < 0.15) beyond = i;
    if (distance > 0.2 && distance < 0.245) wide = i;
    if (distance > 0.255 && distance < 0.3) far = i;
  }
  ASSERT_TRUE(near > 0 && beyond > 0 && wide > 0 && far > 0);
  labels[static_cast<std::size_t>(near)] = 1;
  labels[static_cast<std::size_t>(wide)] = 2;
  labels[static_cast<std::size_t>(far)] = 3;
  labels[static_cast<std::size_t>(beyond)] = 4;
  surface.smooth_normals.row(0) = Eigen::RowVector3d(0.6, 0, 0.8);
  surface.smooth_normals.row(near) = Eigen::RowVector3d(0, 0.6, 0.8);
  const Regions regions = surface_regions(surface, labels, 1);
  const double pair = surface.graph.samples.weights[0] * surface.graph.samples.weights[near] / 36;
  const Eigen::RowVector3d way = (points.row(near) - points.row(0)).normalized();
  EXPECT_NEAR(regions.of(0, 1, PairSum::pairs), pair, 1e-15);
  EXPECT_NEAR(regions.of(0, 1, PairSum::near_pairs), pair, 1e-15);
  EXPECT_NEAR(regions.of(0, 1, PairSum::near_tilt), pair * way.dot(Eigen::RowVector3d(0.6, -0.6, 0)), 1e-15);
  EXPECT_EQ(regions.of(0, 1, PairSum::wide_tilt), regions.of(0, 1, PairSum::near_tilt));
  EXPECT_EQ(regions.of(0, 4, PairSum::near_pairs), 0);
  EXPECT_NEAR(regions.of(0, 4, PairSum::wide_pairs), pair, 1e-15);
  EXPECT_EQ(regions.of(0, 2, PairSum::near_pairs), 0);
  EXPECT_NEAR(regions.of(0, 2, PairSum::wide_pairs), pair, 1e-15);
  EXPECT_EQ(regions.of(0, 3, PairSum::wide_pairs), 0);
  EXPECT_NEAR(regions.of(0, 3, PairSum::pairs), pair, 1e-15);
}

TEST(PatchCosts, AreHigherWhereTheSurfaceIsConcaveOrItsThicknessChanges) {
  const auto cost = [](double turn, double change) {
    ThickSurface surface = test::hand_made_surface(test::hand_made_graph({1, 1}, {{0, 1, 1, 0.5}}), 2);
    // Normals that lean towards each other by the angle where it is positive.
    surface.smooth_normals.row(0) << std::sin(turn / 2), 0, std::cos(turn / 2);
    surface.smooth_normals.row(1) << -std::sin(turn / 2), 0, std::cos(turn / 2);
    surface.log_thickness << -2, -2 + change;
    const std::vector<double> costs = patch_costs(surface);
    EXPECT_EQ(costs.size(), 2U);
    EXPECT_EQ(costs[0], costs[1]);
    return costs[0];
  };
  EXPECT_NEAR(cost(0, 0), 0.5, 1e-9);
  EXPECT_NEAR(cost(0.4, 0), 0.5 + 2 * 0.01 * 0.4, 1e-9);
  EXPECT_NEAR(cost(1.4, 0), 0.5 + 2 * 0.01, 1e-9) << "a radian at most";
  EXPECT_NEAR(cost(-0.4, 0), 0.5, 1e-9) << "a ridge costs nothing";
  EXPECT_NEAR(cost(0, -0.7), 0.5 + 2 * 0.01 * 0.7, 1e-9);
}

TEST(SurfaceRegions, OfAHookDoNotSeeEachOtherInside) {
  // A torus cut in four quarters: those across see each other through the hole, not through the tube.
  const ThickSurface surface = thick_surface(test::torus(4, 0.5, 24, 96));
  std::vector<std::int32_t> quarters;
  for (std::int32_t i = 0; i < surface.graph.size(); ++i) {
    const auto place = surface.graph.samples.points.row(i);
    quarters.push_back((place.x() > 0 ? 0 : 1) + (place.y() > 0 ? 0 : 2));
  }
  const Regions regions = surface_regions(surface, quarters, 300);
  EXPECT_EQ(regions.of(0, 3, PairSum::seen_deep), 0);
  EXPECT_GT(regions.of(0, 3, PairSum::seen_outside), 0.01 * regions.of(0, 3, PairSum::pairs));
  EXPECT_GT(regions.of(0, 0, PairSum::seen_deep), 0.3 * regions.of(0, 0, PairSum::pairs));
}

TEST(SurfaceRegions, SharesAddUpToTheWhole) {
  const Regions regions = regions_of(test::capsule(1, 3, 24, 10), 10);
  double area = 0;
  double opposite = 0;
  for (std::int32_t a = 0; a < regions.initial_size(); ++a) {
    area += regions.of(a).area;
    EXPECT_NEAR(regions.of(a).histogram.sum(), regions.of(a).area, 1e-12);
    for (std::int32_t b = 0; b < regions.initial_size(); ++b) opposite += regions.of(a, b, PairSum::opposite);
  }
  EXPECT_NEAR(area, 1, 1e-9);
  EXPECT_NEAR(opposite, 1, 1e-9);  // every triangle has an opposite side
}

}  // namespace
}  // namespace shapegauge
