// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <vector>

#include "shapegauge/segmentation/patches.h"
#include "shapegauge/segmentation/surface_regions.h"
#include "tests/segmentation/hand_made_surface.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

Regions regions_of(const Shape& shape, int count) {
  const ThickSurface surface = thick_surface(shape);
  return surface_regions(surface, patches(surface.graph, {.count = count}, patch_costs(surface)), 300);
}

TEST(SurfaceRegions, SeeEachOtherOnlyThroughTheInsideOfAConvexShape) {
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

TEST(SurfaceRegions, SeeEachOtherThroughTheOutsideAcrossAConcavity) {
  // Two cubes of side 1 with a gap of 0.5: the facing sides against the rest.
  const Shape right = test::transformed(test::box({1, 1, 1}, 3), 1, Eigen::Matrix3d::Identity(), {1.5, 0, 0});
  const ThickSurface surface = thick_surface(test::joined({test::box({1, 1, 1}, 3), right}));
  const double middle = surface.graph.samples.points.col(0).mean();
  const std::vector<std::int32_t> labels = labelled(surface, [&](const Eigen::RowVector3d& position) {
    const double side = position.x() - middle;
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

TEST(SurfaceRegions, MeasureTheLengthAngleAndThicknessOfTheirBorder) {
  // The top of a box against the rest: a border of length 4, right angles, of which 1.5 radians count.
  ThickSurface surface = thick_surface(test::box({1, 1, 1}, 6));
  const double top = surface.graph.samples.points.col(2).maxCoeff();
  const std::vector<std::int32_t> labels =
      labelled(surface, [&](const Eigen::RowVector3d& position) { return position.z() > top - 1e-9 ? 1 : 0; });
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

TEST(SurfaceRegions, SumsOfARegionWeightNodesByArea) {
  ThickSurface surface = thick_surface(test::box({1, 1, 1}, 4));
  const double top = surface.graph.samples.points.col(2).maxCoeff();
  const std::vector<std::int32_t> labels =
      labelled(surface, [&](const Eigen::RowVector3d& position) { return position.z() > top - 1e-9 ? 1 : 0; });
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
  EXPECT_TRUE((of_top.position / of_top.area).isApprox(Eigen::Vector3d(0, 0, half), 1e-9));
  EXPECT_NEAR(of_top.squared_position(2, 2) / of_top.area, half * half, 1e-12);
  EXPECT_NEAR(of_top.squared_normal(2, 2), of_top.area, 1e-12);
  EXPECT_NEAR(of_top.squared_normal(0, 0), 0, 1e-12);
}

TEST(SurfaceRegions, NormalDifferencesIncludeOnlyPairsOfNearbyNodes) {
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

TEST(PatchCosts, AreHigherAtConcavitiesAndChangesOfThickness) {
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

TEST(SurfaceRegions, OppositeQuartersOfATorusSeeEachOtherOnlyThroughTheHole) {
  // A torus cut in four quarters: those across see each other through the hole, not through the tube.
  const ThickSurface surface = thick_surface(test::torus(4, 0.5, 24, 96));
  std::vector<std::int32_t> quarters;
  for (std::int32_t i = 0; i < surface.graph.size(); ++i) {
    const auto position = surface.graph.samples.points.row(i);
    quarters.push_back((position.x() > 0 ? 0 : 1) + (position.y() > 0 ? 0 : 2));
  }
  const Regions regions = surface_regions(surface, quarters, 300);
  EXPECT_EQ(regions.of(0, 3, PairSum::seen_deep), 0);
  EXPECT_GT(regions.of(0, 3, PairSum::seen_outside), 0.01 * regions.of(0, 3, PairSum::pairs));
  EXPECT_GT(regions.of(0, 0, PairSum::seen_deep), 0.3 * regions.of(0, 0, PairSum::pairs));
}

TEST(SurfaceRegions, AreaFractionsAndOppositePairsSumToOne) {
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

/// Patches of an asymmetric shape with concavities: a box with a ball on its corner.
struct PatchedShape {
  explicit PatchedShape(double scale)
      : surface(thick_surface(test::transformed(
            test::joined({test::box({2, 1, 0.7}, 6),
                          test::transformed(test::sphere(0.5, 2), 1, test::rotation(1), {1, 0.4, 0.3})}),
            scale, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()))),
        labels(patches(surface.graph, {.count = 9}, patch_costs(surface))) {}

  ThickSurface surface;
  std::vector<std::int32_t> labels;
};

void expect_equal_sums(const Regions& a, const Regions& b) {
  ASSERT_EQ(a.initial_size(), b.initial_size());
  for (std::int32_t i = 0; i < a.initial_size(); ++i) {
    EXPECT_EQ(a.of(i).area, b.of(i).area);
    EXPECT_EQ(a.of(i).thickness, b.of(i).thickness);
    EXPECT_EQ(a.of(i).squared_position, b.of(i).squared_position);
    EXPECT_EQ(a.neighbours(i), b.neighbours(i));
    for (std::int32_t k = 0; k < a.initial_size(); ++k) {
      for (std::size_t what = 0; what < pair_sums; ++what) {
        EXPECT_EQ(a.of(i, k, static_cast<PairSum>(what)), b.of(i, k, static_cast<PairSum>(what))) << what;
      }
    }
  }
}

TEST(SurfaceRegions, AreTheSameForAnySizeAndNumberOfThreads) {
  const PatchedShape patched(1);
  const tbb::global_control more_threads_than_cores(tbb::global_control::max_allowed_parallelism, 8);
  const auto measured = [](const PatchedShape& one, int threads) {
    return tbb::task_arena(threads).execute([&] { return surface_regions(one.surface, one.labels, 150); });
  };
  const Regions serial = measured(patched, 1);
  expect_equal_sums(serial, measured(patched, 5));
  const PatchedShape larger(4);  // a power of 2: no other rounding
  ASSERT_EQ(larger.labels, patched.labels);
  expect_equal_sums(serial, measured(larger, 1));
}

TEST(SurfaceRegions, OfMergedPatchesMatchRegionsMeasuredDirectly) {
  PatchedShape patched(1);
  Regions merged = surface_regions(patched.surface, patched.labels, 30);
  const std::int32_t target = 1;
  ASSERT_FALSE(merged.neighbours(target).empty());
  const std::int32_t other = *merged.neighbours(target).begin();
  merged.merge(target, other);
  std::ranges::replace(patched.labels, other, target);
  const Regions measured = surface_regions(patched.surface, patched.labels, 30);
  EXPECT_NEAR(merged.of(target).area, measured.of(target).area, 1e-12);
  EXPECT_TRUE(merged.of(target).squared_position.isApprox(measured.of(target).squared_position, 1e-12));
  EXPECT_TRUE(merged.of(target).squared_normal.isApprox(measured.of(target).squared_normal, 1e-12));
  EXPECT_TRUE(merged.of(target).histogram.isApprox(measured.of(target).histogram, 1e-12));
  EXPECT_EQ(merged.neighbours(target), measured.neighbours(target));
  for (std::int32_t i = 0; i < merged.initial_size(); ++i) {
    if (i == other) continue;
    EXPECT_NEAR(merged.of(target, i, PairSum::opposite), measured.of(target, i, PairSum::opposite), 1e-12);
    if (i == target) continue;
    for (const PairSum what :
         {PairSum::border, PairSum::concave, PairSum::convex, PairSum::folded, PairSum::thickness}) {
      EXPECT_NEAR(merged.of(target, i, what), measured.of(target, i, what), 1e-12);
    }
  }
}

}  // namespace
}  // namespace shapegauge
