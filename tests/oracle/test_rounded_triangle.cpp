#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/core/spatial/random_triangle.h"
#include "tests/oracle/rounded_triangle.h"

namespace shapegauge {
namespace {

double distance(const Triangle& triangle, const Eigen::Vector3d& x) { return (closest_point(triangle, x) - x).norm(); }

RC_GTEST_PROP(RoundedTriangle, IsLeftWhereTheDistanceReachesTheRadius, ()) {
  const Triangle triangle = random_triangle();
  const double radius = *rc::gen::inRange(1, 1500) / 1000.0;
  const Eigen::Vector3d origin = random_point();
  const Eigen::Vector3d towards = random_point();
  RC_PRE((towards - origin).norm() > 1e-3);
  const Eigen::Vector3d direction = (towards - origin).normalized();
  RC_PRE(distance(triangle, origin) < radius);
  const double exit = exit_from_rounded_triangle(triangle, radius, origin, direction);
  RC_ASSERT(exit >= 0);
  RC_ASSERT(std::abs(distance(triangle, origin + exit * direction) - radius) <= 1e-7);
  // The body is convex: the ray is inside all the way, and outside from there on.
  for (int i = 1; i < 20; ++i) {
    RC_ASSERT(distance(triangle, origin + exit * i / 20.0 * direction) <= radius + 1e-9);
    RC_ASSERT(distance(triangle, origin + (exit + 0.1 * i) * direction) >= radius - 1e-9);
  }
}

TEST(RoundedTriangle, IsMissedByARayThatPassesByOrBegunBehindIt) {
  const Triangle triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_LT(exit_from_rounded_triangle(triangle, 0.1, {0, 0, 1}, {1, 0, 0}), 0);
  EXPECT_LT(exit_from_rounded_triangle(triangle, 0.1, {0.2, 0.2, 1}, {0, 0, 1}), 0);
}

}  // namespace
}  // namespace shapegauge
