// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/preparation/tube_area.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

/// V / 2r of a box: its sides, quarter cylinders and eighths of balls outside, less what overlaps inside.
double tube_area_of_box(const Eigen::Vector3d& size, double r) {
  const double sides = 2 * (size[0] * size[1] + size[1] * size[2] + size[2] * size[0]);
  const double outside = sides * r + std::numbers::pi * r * r * size.sum() + 4 * std::numbers::pi / 3 * r * r * r;
  const double inside = size.prod() - (size.array() - 2 * r).prod();
  return (outside + inside) / (2 * r);
}

TEST(TubeArea, MatchesTheTubeFormulaOfWeyl) {
  const Shape sphere = test::sphere(1, 5);
  const Shape torus = test::torus(2, 0.7, 120, 240);
  const Eigen::Vector3d size(1, 2, 3);
  for (const double radius : {0.01, 0.02, 0.05}) {
    const double r = radius * bounding_box_diagonal(sphere);
    EXPECT_NEAR(tube_area(sphere, radius) / surface_area(sphere), 1 + r * r / 3, 1e-3) << radius;
    EXPECT_NEAR(tube_area(torus, radius) / surface_area(torus), 1, 1e-3) << radius;
    const Shape box = test::box(size, 6);
    const double expected = tube_area_of_box(size, radius * bounding_box_diagonal(box));
    EXPECT_NEAR(tube_area(box, radius) / expected, 1, 5e-3) << radius;
  }
}

TEST(TubeArea, IsTheSurfaceAreaForTinyRadii) {
  const Shape sphere = test::sphere(1, 5);
  for (const double radius : {0.0005, 0.001, 0.002}) {
    EXPECT_NEAR(tube_area(sphere, radius) / surface_area(sphere), 1, 0.02) << radius;
  }
}

TEST(TubeArea, HardlyChangesIfFacesAreMissing) {
  for (const Shape& mesh : {test::sphere(1, 4), test::torus(2, 0.7, 60, 120), test::box({1, 2, 3}, 20)}) {
    RandomNumbers random(1);
    const Shape cracked = remove_faces(mesh, 0.15, random);
    EXPECT_NEAR(surface_area(cracked) / surface_area(mesh), 0.85, 0.01);
    EXPECT_NEAR(tube_area(cracked) / tube_area(mesh), 1, 0.01);
  }
}

TEST(TubeArea, GrowsLessThanTheSurfaceAreaUnderNoise) {
  const Shape torus = test::torus(2, 0.7, 60, 120);
  RandomNumbers random(1);
  const Shape noisy = vertex_noise(torus, {.amplitude = 0.005, .distribution = NoiseDistribution::gaussian}, random);
  EXPECT_GT(surface_area(noisy) / surface_area(torus), 1.5);
  EXPECT_LT(tube_area(noisy) / tube_area(torus), 1.25);
}

TEST(TubeArea, OfAPointCloudMatchesThatOfTheSampledMesh) {
  for (const Shape& mesh : {test::sphere(1, 5), test::torus(2, 0.7, 60, 120), test::box({1, 2, 3}, 20)}) {
    for (const auto& [points, tolerance] : {std::pair(3000, 0.03), {10000, 0.01}}) {
      const Shape cloud = test::random_points(mesh, points, 1);
      EXPECT_NEAR(tube_area(cloud) / tube_area(mesh), 1, tolerance) << points;
      EXPECT_EQ(tube_area(test::joined({cloud, cloud})), tube_area(cloud));
    }
  }
}

TEST(TubeArea, ScalesWithTheShapeAndIgnoresTranslation) {
  const Shape torus = test::torus(2, 0.7, 40, 80);
  const double area = tube_area(torus);
  for (const double scale : {1e-30, 1e-3, 1e30}) {
    const Shape scaled = test::transformed(torus, scale, Eigen::Matrix3d::Identity(), {0, 0, 0});
    EXPECT_NEAR(tube_area(scaled) / scale / scale, area, 1e-3 * area);
    // Turned, the box and its diagonal, and so r, are others.
    const Shape turned = test::transformed(scaled, 1, test::rotation(3), scale * Eigen::Vector3d(5, 6, 7));
    EXPECT_NEAR(tube_area(turned) / scale / scale, area, 3e-3 * area);
  }
}

TEST(TubeArea, RejectsShapesWithoutExtentAndInvalidRadii) {
  const Shape sphere = test::sphere(1, 1);
  for (const double radius : {0.0, -1.0, 1.1, std::nan("")}) {
    EXPECT_THROW(tube_area(sphere, radius), InputError);
  }
  EXPECT_THROW(tube_area({}), InputError);
  EXPECT_THROW(tube_area({Points::Ones(7, 3), {}}), InputError);
  Shape unusable = sphere;
  unusable.vertices(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(tube_area(unusable), InputError);
  unusable = sphere;
  unusable.triangles(0, 0) = 4711;
  EXPECT_THROW(tube_area(unusable), InputError);
}

}  // namespace

}  // namespace shapegauge
