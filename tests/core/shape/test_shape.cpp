#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "shapegauge/core/shape/shape.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

TEST(Shape, EmptyShapeHasNoExtentAndNoArea) {
  EXPECT_EQ(bounding_box_diagonal(Shape{}), 0);
  EXPECT_EQ(surface_area(Shape{}), 0);
}

TEST(Shape, MeasuresOfABox) {
  const Shape box = test_shapes::box({1, 2, 2}, 3);
  EXPECT_NEAR(bounding_box_diagonal(box), 3, 1e-14);
  EXPECT_NEAR(surface_area(box), 16, 1e-13);
}

TEST(Shape, AreaOfATorusConvergesToTheFormula) {
  const double expected = 4 * std::numbers::pi * std::numbers::pi * 3 * 1;
  EXPECT_NEAR(surface_area(test_shapes::torus(3, 1, 200, 200)) / expected, 1, 1e-3);
}

TEST(Shape, VerticesThatNoTriangleUsesDoNotCount) {
  Shape box = test_shapes::box({1, 2, 2}, 1);
  box.vertices.conservativeResize(box.vertices.rows() + 1, 3);
  box.vertices.bottomRows<1>() << 100, 100, 100;
  EXPECT_NEAR(bounding_box_diagonal(box), 3, 1e-14);
}

TEST(Shape, AllPointsOfACloudCount) {
  Shape cloud = test_shapes::box({1, 2, 2}, 1);
  cloud.triangles.resize(0, 3);
  EXPECT_NEAR(bounding_box_diagonal(cloud), 3, 1e-14);
  EXPECT_EQ(surface_area(cloud), 0);
}

}  // namespace
}  // namespace shapegauge
