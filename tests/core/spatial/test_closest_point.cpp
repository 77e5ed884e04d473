// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "shapegauge/core/spatial/closest_point.h"
#include "tests/core/spatial/random_triangle.h"

namespace shapegauge {
namespace {

RC_GTEST_PROP(ClosestPoint, IsAsCloseAsAnyPointOfAFineGridOnTheTriangle, ()) {
  const Triangle triangle = random_triangle();
  const Eigen::Vector3d x = random_point();
  const Eigen::Vector3d found = closest_point(triangle, x);
  constexpr int steps = 60;
  double smallest = (triangle.a - x).norm();
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      const double v = static_cast<double>(i) / steps;
      const double w = static_cast<double>(j) / steps;
      const Eigen::Vector3d y = triangle.a + v * (triangle.b - triangle.a) + w * (triangle.c - triangle.a);
      smallest = std::min(smallest, (y - x).norm());
    }
  }
  const double size = std::max((triangle.b - triangle.a).norm(), (triangle.c - triangle.a).norm());
  RC_ASSERT((found - x).norm() <= smallest + 1e-12);
  RC_ASSERT((found - x).norm() >= smallest - 2 * size / steps);
  // It is a point of the triangle: its own closest point is itself.
  RC_ASSERT((closest_point(triangle, found) - found).norm() <= 1e-9);
}

TEST(ClosestPoint, OfADegenerateTriangleLiesOnItsSegmentOrPoint) {
  const Eigen::Vector3d a(0, 0, 0);
  const Eigen::Vector3d b(2, 0, 0);
  EXPECT_EQ(closest_point({a, a, a}, {1, 1, 1}), a);
  EXPECT_EQ(closest_point({a, b, a}, {1, 1, 0}), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(closest_point({a, Eigen::Vector3d(1, 0, 0), b}, {5, 1, 0}), b);
}

}  // namespace
}  // namespace shapegauge
