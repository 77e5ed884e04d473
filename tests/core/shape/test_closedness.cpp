#include <gtest/gtest.h>

#include "shapegauge/core/shape/closedness.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

TEST(Closedness, HoldsForClosedSurfacesHoweverOriented) {
  const Shape sphere = test_shapes::sphere(1, 2);
  EXPECT_TRUE(is_closed(sphere));
  EXPECT_TRUE(is_closed(test_shapes::flipped(sphere)));
  EXPECT_TRUE(is_closed(test_shapes::joined({sphere, test_shapes::torus(3, 1, 12, 8)})));
}

TEST(Closedness, EndsWithOneTriangle) {
  Shape sphere = test_shapes::sphere(1, 2);
  sphere.triangles.conservativeResize(sphere.triangles.rows() - 1, Eigen::NoChange);
  EXPECT_FALSE(is_closed(sphere));
  EXPECT_FALSE(is_closed(Shape{}));
}

TEST(Closedness, TakesVerticesAtTheSamePlaceAsOne) {
  EXPECT_TRUE(is_closed(test_shapes::soup(test_shapes::sphere(1, 1))));
}

TEST(Closedness, LeavesOutTrianglesWithoutArea) {
  Shape sphere = test_shapes::sphere(1, 1);
  sphere.triangles.conservativeResize(sphere.triangles.rows() + 1, Eigen::NoChange);
  sphere.triangles.bottomRows(1) << 0, 0, 1;
  EXPECT_TRUE(is_closed(sphere));
}

}  // namespace
}  // namespace shapegauge
