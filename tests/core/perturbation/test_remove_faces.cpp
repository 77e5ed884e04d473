#include <gtest/gtest.h>

#include "shapegauge/core/error.h"
#include "shapegauge/core/perturbation/remove_faces.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

Shape thinned(const Shape& shape, double fraction, std::uint64_t seed) {
  RandomNumbers random(seed);
  return remove_faces(shape, fraction, random);
}

TEST(RemoveFaces, TakesTheRoundedNumberAway) {
  const Shape sphere = test_shapes::sphere(1, 3);  // 1280 faces
  EXPECT_EQ(thinned(sphere, 0.15, 1).triangles.rows(), 1280 - 192);
  EXPECT_EQ(thinned(sphere, 0, 1).triangles, sphere.triangles);
  EXPECT_EQ(thinned(sphere, 0.15, 1).vertices, sphere.vertices);
  EXPECT_EQ(thinned(sphere, 0.15, 1).triangles, thinned(sphere, 0.15, 1).triangles);
  EXPECT_NE(thinned(sphere, 0.15, 1).triangles, thinned(sphere, 0.15, 2).triangles);
}

TEST(RemoveFaces, RemovesThePointsOfACloud) {
  Shape cloud;
  cloud.vertices = test_shapes::sphere(1, 2).vertices;  // 162 points
  EXPECT_EQ(thinned(cloud, 0.5, 1).vertices.rows(), 81);
}

TEST(RemoveFaces, LeavesAtLeastOne) {
  EXPECT_THROW(thinned(test_shapes::box({1, 1, 1}, 1), 1, 1), InputError);
  EXPECT_THROW(thinned(test_shapes::box({1, 1, 1}, 1), -0.5, 1), InputError);
  EXPECT_THROW(thinned(Shape{}, 0, 1), InputError);
}

}  // namespace
}  // namespace shapegauge
