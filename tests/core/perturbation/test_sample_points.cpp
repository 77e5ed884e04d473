// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/perturbation/sample_points.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

Shape sampled(const Shape& shape, const SamplePointsOptions& options, std::uint64_t seed) {
  RandomNumbers random(seed);
  return sample_points(shape, options, random);
}

TEST(SampleSurface, PointsLieOnTheSurfaceUniformlyByArea) {
  const Shape box = test::box({1, 2, 4}, 3);
  const Shape cloud = sampled(box, {.points = 28000}, 1);
  ASSERT_EQ(cloud.vertices.rows(), 28000);
  EXPECT_EQ(cloud.triangles.rows(), 0);
  EXPECT_EQ(cloud.normals.rows(), 0);
  const Eigen::RowVector3d half(0.5, 1, 2);
  std::array<int, 3> on_side{};
  int near_end = 0;  // of the two sides across x: the quarter with z > 1
  for (const auto& point : cloud.vertices.rowwise()) {
    const Eigen::RowVector3d gap = half - point.cwiseAbs();
    ASSERT_NEAR(gap.minCoeff(), 0, 1e-12);
    Eigen::Index axis = 0;
    gap.minCoeff(&axis);
    ++on_side[static_cast<std::size_t>(axis)];
    if (axis == 0 && point[2] > 1) ++near_end;
  }
  // Of the area 28, sides have 16, 8 and 4. Stratified numbers scatter less than these binomial ones; four deviations.
  EXPECT_NEAR(on_side[0], 16000, 4 * std::sqrt(28000 * 4. / 7 * 3. / 7));
  EXPECT_NEAR(on_side[1], 8000, 4 * std::sqrt(28000 * 2. / 7 * 5. / 7));
  EXPECT_NEAR(near_end, 4000, 4 * std::sqrt(28000 * 1. / 7 * 6. / 7));
}

TEST(SampleSurface, StratifiesSamplesByArea) {
  // 1280 triangles of nearly equal area, two points each: independent sampling would miss one in seven.
  const Shape sphere = test::sphere(1, 3);
  const Shape cloud = sampled(sphere, {.points = 2560, .with_normals = true}, 1);
  Eigen::Index different = 0;
  for (Eigen::Index i = 1; i < cloud.normals.rows(); ++i) {
    if (cloud.normals.row(i) != cloud.normals.row(i - 1)) ++different;
  }
  EXPECT_GT(different, 1200);
}

TEST(SampleSurface, GivesPointsTheNormalsOfTheirTriangles) {
  const Shape cloud = sampled(test::sphere(2, 4), {.points = 1000, .with_normals = true}, 1);
  ASSERT_EQ(cloud.normals.rows(), 1000);
  for (Eigen::Index i = 0; i < 1000; ++i) {
    EXPECT_NEAR(cloud.normals.row(i).norm(), 1, 1e-12);
    EXPECT_GT(cloud.normals.row(i).dot(cloud.vertices.row(i).normalized()), 0.99);
  }
}

TEST(SampleSurface, DependsOnTheSeedAndNotOnTheSizeOfTheShape) {
  const Shape box = test::box({1, 2, 3}, 2);
  EXPECT_EQ(sampled(box, {.points = 100}, 1).vertices, sampled(box, {.points = 100}, 1).vertices);
  EXPECT_NE(sampled(box, {.points = 100}, 1).vertices, sampled(box, {.points = 100}, 2).vertices);
  Shape tiny = box;
  tiny.vertices *= 0x1p-100;
  EXPECT_EQ(sampled(tiny, {.points = 100}, 1).vertices, sampled(box, {.points = 100}, 1).vertices * 0x1p-100);
}

TEST(SampleSurface, SkipsDegenerateTriangles) {
  Shape shape = test::box({1, 1, 1}, 1);
  Triangles triangles(14, 3);
  triangles << 0, 0, 1, shape.triangles, 1, 1, 1;
  shape.triangles = triangles;
  EXPECT_TRUE(sampled(shape, {.points = 1000, .with_normals = true}, 1).normals.rowwise().norm().minCoeff() > 0.99);
}

TEST(SampleSurface, SelectsASubsetOfThePointsOfACloud) {
  Shape cloud{.vertices = test::sphere(1, 3).vertices, .triangles = {}};
  cloud.normals = cloud.vertices;
  const Shape fewer = sampled(cloud, {.points = 101, .with_normals = true}, 1);
  EXPECT_EQ(fewer.vertices.rows(), 101);
  EXPECT_EQ(fewer.normals, fewer.vertices);
  EXPECT_EQ(sampled(cloud, {.points = 100000}, 1).vertices, cloud.vertices);
  EXPECT_EQ(sampled(cloud, {.points = 100000}, 1).normals.rows(), 0);
}

TEST(SampleSurface, RejectsShapesWithoutArea) {
  EXPECT_THROW(sampled(Shape{}, {}, 1), InputError);
  EXPECT_THROW(sampled(test::box({1, 1, 1}, 1), {.points = 0}, 1), InputError);
  EXPECT_THROW(sampled(test::box({0, 0, 1}, 1), {}, 1), InputError);
}

TEST(VertexCloud, ContainsOnlyTheVerticesUsedByTriangles) {
  Shape sphere = test::sphere(1, 1);
  const Points used = sphere.vertices;
  sphere.vertices.conservativeResize(used.rows() + 1, 3);
  sphere.vertices.bottomRows(1).setConstant(9);
  const Shape cloud = vertex_cloud(sphere);
  EXPECT_TRUE(is_cloud(cloud));
  EXPECT_EQ(cloud.vertices, used);
}

TEST(VertexCloud, KeepsThePointsOfACloud) {
  const Points points = test::sphere(1, 1).vertices;
  const Shape cloud = vertex_cloud({points, {}, points});
  EXPECT_EQ(cloud.vertices, points);
  EXPECT_EQ(cloud.normals.rows(), 0);
}

}  // namespace

}  // namespace shapegauge
