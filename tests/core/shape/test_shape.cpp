// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/shape/shape.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

TEST(Shape, HasNoExtentAndNoAreaIfEmpty) {
  EXPECT_EQ(bounding_box_diagonal(Shape{}), 0);
  EXPECT_EQ(surface_area(Shape{}), 0);
}

TEST(Shape, DiagonalAndAreaOfABoxAreExact) {
  const Shape box = test::box({1, 2, 2}, 3);
  EXPECT_NEAR(bounding_box_diagonal(box), 3, 1e-14);
  EXPECT_NEAR(surface_area(box), 16, 1e-13);
}

TEST(TriangleNormal, FollowsTheOrderOfCornersAndIsZeroForDegenerateTriangles) {
  const Shape mesh{.vertices = Points{{0, 0, 0}, {3, 0, 0}, {0, 1e-200, 0}, {1e200, 0, 0}, {0, 1e200, 0}},
                   .triangles = Triangles{{0, 1, 2}, {0, 2, 1}, {0, 1, 1}, {0, 3, 4}}};
  EXPECT_EQ(triangle_normal(mesh, 0), Eigen::RowVector3d(0, 0, 1));
  EXPECT_EQ(triangle_normal(mesh, 1), Eigen::RowVector3d(0, 0, -1));
  EXPECT_EQ(triangle_normal(mesh, 2), Eigen::RowVector3d::Zero());
  EXPECT_EQ(triangle_normal(mesh, 3), Eigen::RowVector3d::Zero());  // overflow
}

TEST(Shape, AreaOfATorusConvergesToTheFormula) {
  const double expected = 4 * std::numbers::pi * std::numbers::pi * 3 * 1;
  EXPECT_NEAR(surface_area(test::torus(3, 1, 200, 200)) / expected, 1, 1e-3);
}

TEST(Shape, DiagonalIgnoresUnusedVertices) {
  Shape box = test::box({1, 2, 2}, 1);
  box.vertices.conservativeResize(box.vertices.rows() + 1, 3);
  box.vertices.bottomRows<1>() << 100, 100, 100;
  EXPECT_NEAR(bounding_box_diagonal(box), 3, 1e-14);
}

TEST(Shape, DiagonalOfACloudUsesAllPoints) {
  Shape cloud = test::box({1, 2, 2}, 1);
  cloud.triangles.resize(0, 3);
  EXPECT_NEAR(bounding_box_diagonal(cloud), 3, 1e-14);
  EXPECT_EQ(surface_area(cloud), 0);
}

TEST(ShapeCheck, AcceptsValidShapes) {
  EXPECT_EQ(find_defect(test::box({1, 2, 0}, 1)), std::nullopt);
  EXPECT_EQ(find_defect(Shape{}), std::nullopt);
  EXPECT_NO_THROW(require_usable(test::sphere(1e300, 1)));
}

TEST(ShapeCheck, NamesTheFirstNonFiniteVertex) {
  Shape shape = test::box({1, 1, 1}, 1);
  shape.vertices(5, 2) = std::numeric_limits<double>::quiet_NaN();
  shape.vertices(3, 0) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(find_defect(shape), "vertex 3 has a coordinate that is not a finite number");
  EXPECT_THROW(require_usable(shape), InputError);
}

TEST(ShapeCheck, NamesTheFirstTriangleWithAnInvalidIndex) {
  Shape shape = test::box({1, 1, 1}, 1);
  const auto vertices = static_cast<std::int32_t>(shape.vertices.rows());
  shape.triangles(7, 0) = -1;
  EXPECT_EQ(find_defect(shape), "triangle 7 has a vertex outside 0.." + std::to_string(vertices - 1));
  shape.triangles(4, 2) = vertices;
  EXPECT_EQ(find_defect(shape), "triangle 4 has a vertex outside 0.." + std::to_string(vertices - 1));
}

}  // namespace

}  // namespace shapegauge
