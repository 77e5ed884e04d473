// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shapegauge/core/preparation/cavities.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

TEST(Cavities, AreInnerSurfacesThatFaceInwards) {
  const Shape outer = test::box({4, 4, 4}, 2);
  const Shape hollow = test::joined({outer, test::flipped(test::sphere(1, 2))});
  EXPECT_EQ(closed_components(outer).cavities, 0U);
  EXPECT_EQ(closed_components(hollow).cavities, 1U);
  EXPECT_EQ(closed_components(test::flipped(hollow)).cavities, 1U);
  EXPECT_EQ(closed_components(test::soup(hollow)).cavities, 1U);
  const Eigen::Matrix3d same = Eigen::Matrix3d::Identity();
  const Shape small = test::flipped(test::sphere(0.3, 1));
  const Shape two = test::joined(
      {outer, test::transformed(small, 1, same, {1, 0, 0}), test::transformed(small, 1, same, {-1, 0, 0})});
  EXPECT_EQ(closed_components(two).cavities, 2U);
}

TEST(Cavities, ExcludeSolidsInsideSolids) {
  EXPECT_EQ(closed_components(test::joined({test::box({4, 4, 4}, 2), test::sphere(1, 2)})).cavities, 0U);
  const Shape outside = test::transformed(test::flipped(test::sphere(1, 2)), 1, Eigen::Matrix3d::Identity(), {9, 0, 0});
  EXPECT_EQ(closed_components(test::joined({test::box({4, 4, 4}, 2), outside})).cavities, 0U);
}

TEST(Cavities, ExcludeReversedBodiesThatNoBodyEncloses) {
  const Shape small = test::transformed(test::box({1, 1, 1}, 1), 1, Eigen::Matrix3d::Identity(), {9, 0, 0});
  const Shape large = test::box({2, 2, 2}, 2);
  const ClosedComponents mixed = closed_components(test::joined({large, test::flipped(small)}));
  EXPECT_EQ(mixed.reversed, 1U);
  EXPECT_EQ(mixed.cavities, 0U);
  EXPECT_DOUBLE_EQ(mixed.volume, 9);
  EXPECT_EQ(closed_components(test::joined({large, small})).reversed, 0U);
  EXPECT_DOUBLE_EQ(closed_components(test::joined({large, test::flipped(test::box({1, 1, 1}, 1))})).volume, 7);
}

TEST(Cavities, AreNotFoundInOpenMeshesAndClouds) {
  Shape open = test::joined({test::box({4, 4, 4}, 2), test::flipped(test::sphere(1, 2))});
  open.triangles.conservativeResize(open.triangles.rows() - 1, Eigen::NoChange);
  EXPECT_EQ(closed_components(open).cavities, 0U);
  EXPECT_EQ(closed_components(test::random_points(test::sphere(1, 2), 50, 1)).cavities, 0U);
}

}  // namespace
}  // namespace shapegauge
