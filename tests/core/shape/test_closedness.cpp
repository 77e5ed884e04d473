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
  const Shape sphere = test_shapes::sphere(1, 1);
  Shape soup;
  soup.vertices.resize(3 * sphere.triangles.rows(), 3);
  soup.triangles.resize(sphere.triangles.rows(), 3);
  for (Eigen::Index f = 0; f < sphere.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      soup.vertices.row(3 * f + k) = sphere.vertices.row(sphere.triangles(f, k));
      soup.triangles(f, k) = static_cast<std::int32_t>(3 * f + k);
    }
  }
  EXPECT_TRUE(is_closed(soup));
}

TEST(Closedness, LeavesOutTrianglesWithoutArea) {
  Shape sphere = test_shapes::sphere(1, 1);
  sphere.triangles.conservativeResize(sphere.triangles.rows() + 1, Eigen::NoChange);
  sphere.triangles.bottomRows(1) << 0, 0, 1;
  EXPECT_TRUE(is_closed(sphere));
}

}  // namespace
}  // namespace shapegauge
