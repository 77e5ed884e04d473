#include <cmath>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "shapegauge/core/preparation/inscribed_circle.h"

namespace shapegauge {
namespace {

using Polygon = std::vector<Eigen::Vector2d>;

TEST(InscribedCircle, OfKnownPolygons) {
  EXPECT_NEAR(inscribed_circle_radius({{0, 0}, {4, 0}, {4, 2}, {0, 2}}), 1, 0.01);
  EXPECT_NEAR(inscribed_circle_radius({{0, 0}, {0, 3}, {4, 0}}), 1, 0.01);  // clockwise; the 3-4-5 triangle
  // An L of arms 1 wide: the circle in the corner touches both outer sides and the inner corner.
  const double corner = 2 - std::sqrt(2.0);
  EXPECT_NEAR(inscribed_circle_radius({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}), corner, 0.01 * corner);
  // A slit that runs into a square hole adds to its length, not to its width.
  EXPECT_NEAR(inscribed_circle_radius({{0, 0}, {1, 0}, {1, 0.45}, {9, 0.45}, {9, 0.55}, {1, 0.55}, {1, 1}, {0, 1}}),
              0.5, 0.01);
}

TEST(InscribedCircle, OfNothing) {
  EXPECT_EQ(inscribed_circle_radius({}), 0);
  EXPECT_EQ(inscribed_circle_radius({{1, 1}, {2, 2}}), 0);
  EXPECT_EQ(inscribed_circle_radius({{1, 1}, {2, 2}, {3, 3}}), 0);
}

RC_GTEST_PROP(InscribedCircle, OfAnyTriangleIsTwiceTheAreaByTheLength, ()) {
  const auto coordinate = [] { return *rc::gen::inRange(-1000, 1000) / 100.0; };
  const Polygon triangle{{coordinate(), coordinate()}, {coordinate(), coordinate()}, {coordinate(), coordinate()}};
  const Eigen::Vector2d ab = triangle[1] - triangle[0];
  const Eigen::Vector2d ac = triangle[2] - triangle[0];
  const double doubled_area = std::abs(ab.x() * ac.y() - ab.y() * ac.x());
  const double length = ab.norm() + ac.norm() + (ac - ab).norm();
  const double radius = inscribed_circle_radius(triangle);
  RC_ASSERT(radius * length <= doubled_area * (1 + 1e-9));
  double diagonal = 0;
  for (const Eigen::Vector2d& side : {ab, ac, Eigen::Vector2d(ac - ab)}) diagonal = std::max(diagonal, side.norm());
  // The box's diagonal is at most the root of two times the longest side.
  RC_ASSERT(radius * 1.01 + 1.5e-3 * diagonal >= doubled_area / std::max(length, 1e-9) * (1 - 1e-9));
}

}  // namespace
}  // namespace shapegauge
