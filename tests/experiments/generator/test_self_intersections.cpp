#include <gtest/gtest.h>

#include "shapegauge/experiments/generator/self_intersections.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

TEST(SelfIntersections, AreFoundWhereTwoSpheresCross) {
  const Shape sphere = test_shapes::sphere(1, 2);
  const auto moved = [&](double x) {
    return test_shapes::transformed(sphere, 1, Eigen::Matrix3d::Identity(), {x, 0.01, 0.02});
  };
  EXPECT_FALSE(self_intersects(sphere));
  EXPECT_TRUE(self_intersects(test_shapes::joined({sphere, moved(1.9)})));
  EXPECT_FALSE(self_intersects(test_shapes::joined({sphere, moved(2.1)})));
}

}  // namespace
}  // namespace shapegauge
