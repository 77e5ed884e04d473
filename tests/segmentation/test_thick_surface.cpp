// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/segmentation/thick_surface.h"
#include "tests/segmentation/hand_made_surface.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

void expect_thickness(const ThickSurface& surface, double expected, double tolerance) {
  for (const double thickness : surface.log_thickness) EXPECT_NEAR(thickness, expected, tolerance);
}

TEST(ThickSurface, ThicknessOfASphereIsItsDiameter) {
  // 2 R over the square root of 4 pi R^2, whatever R is.
  const double expected = -std::log(std::numbers::pi) / 2;
  for (const double radius : {1.0, 40.0}) {
    const ThickSurface surface = thick_surface(test::sphere(radius, 3));
    EXPECT_NEAR(surface.unit, radius * std::sqrt(4 * std::numbers::pi), 0.01 * surface.unit);
    expect_thickness(surface, expected, 0.05);
  }
}

TEST(ThickSurface, OfAReversedSphereHasTheSameThicknessAndOutwardNormals) {
  const Shape sphere = test::sphere(1, 3);
  const ThickSurface surface = thick_surface(test::flipped(sphere));
  expect_thickness(surface, -std::log(std::numbers::pi) / 2, 0.05);
  EXPECT_GT(signed_volume(surface.barrier), 0);
  for (std::int32_t i = 0; i < surface.graph.size(); ++i) {
    EXPECT_GT(surface.graph.samples.normals.row(i).dot(surface.graph.samples.points.row(i)), 0.9);
  }
}

TEST(ThickSurface, CloudHasTheThicknessAndNormalsOfItsSurface) {
  const Shape cloud{.vertices = test::sphere(1, 4).vertices, .triangles = {}};
  const ThickSurface surface = thick_surface(cloud);
  expect_thickness(surface, -std::log(std::numbers::pi) / 2, 0.05);
  EXPECT_GT(surface.barrier_triangles_per_node, 1);
  EXPECT_EQ(surface.barrier.triangles.rows(), surface.barrier_triangles_per_node * cloud.vertices.rows());
  for (std::int32_t i = 0; i < surface.graph.size(); ++i) {
    EXPECT_GT(surface.graph.samples.normals.row(i).dot(surface.graph.samples.points.row(i)), 0.9);
  }
}

TEST(ThickSurface, DihedralAnglesUseSmoothedNormals) {
  ThickSurface surface = test::hand_made_surface(test::hand_made_graph({1, 1}, {{0, 1, 1}}), 1);
  surface.smooth_normals.row(0) << std::sin(0.2), 0, std::cos(0.2);
  EXPECT_NEAR(surface.normal_angle(0, surface.graph.links[0]), 0.2, 1e-12);
  EXPECT_NEAR(surface.normal_angle(1, surface.graph.links[1]), 0.2, 1e-12);
  surface.smooth_normals(0, 0) *= -1;
  EXPECT_NEAR(surface.normal_angle(0, surface.graph.links[0]), -0.2, 1e-12);
}

TEST(ThickSurface, OrientsOnlyClosedMeshesOutward) {
  const Shape sphere = test::sphere(1, 1);
  EXPECT_EQ(orient_outward(sphere).triangles, sphere.triangles);
  EXPECT_GT(signed_volume(orient_outward(test::flipped(sphere))), 0);
  Shape open = test::flipped(sphere);
  open.triangles.conservativeResize(open.triangles.rows() - 1, 3);
  EXPECT_EQ(orient_outward(open).triangles, open.triangles);
}

TEST(ThickSurface, RefusesAShapeWithoutArea) {
  Shape flat = test::box({1, 1, 1}, 1);
  flat.vertices.setZero();
  EXPECT_THROW(thick_surface(flat), InputError);
}

}  // namespace
}  // namespace shapegauge
