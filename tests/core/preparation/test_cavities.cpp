#include <gtest/gtest.h>

#include "shapegauge/core/preparation/cavities.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

TEST(Cavities, AreInnerSurfacesThatFaceInwards) {
  const Shape outer = test::box({4, 4, 4}, 2);
  const Shape hollow = test::joined({outer, test::flipped(test::sphere(1, 2))});
  EXPECT_EQ(cavity_count(outer), 0U);
  EXPECT_EQ(cavity_count(hollow), 1U);
  EXPECT_EQ(cavity_count(test::flipped(hollow)), 1U);
  EXPECT_EQ(cavity_count(test::soup(hollow)), 1U);
  const Eigen::Matrix3d same = Eigen::Matrix3d::Identity();
  const Shape small = test::flipped(test::sphere(0.3, 1));
  const Shape two = test::joined(
      {outer, test::transformed(small, 1, same, {1, 0, 0}), test::transformed(small, 1, same, {-1, 0, 0})});
  EXPECT_EQ(cavity_count(two), 2U);
}

TEST(Cavities, ASolidInASolidIsNone) {
  EXPECT_EQ(cavity_count(test::joined({test::box({4, 4, 4}, 2), test::sphere(1, 2)})), 0U);
  const Shape beside = test::transformed(test::flipped(test::sphere(1, 2)), 1, Eigen::Matrix3d::Identity(), {9, 0, 0});
  EXPECT_EQ(cavity_count(test::joined({test::box({4, 4, 4}, 2), beside})), 0U);
}

TEST(Cavities, OpenMeshesAndCloudsHaveNone) {
  Shape open = test::joined({test::box({4, 4, 4}, 2), test::flipped(test::sphere(1, 2))});
  open.triangles.conservativeResize(open.triangles.rows() - 1, Eigen::NoChange);
  EXPECT_EQ(cavity_count(open), 0U);
  EXPECT_EQ(cavity_count(test::random_points(test::sphere(1, 2), 50, 1)), 0U);
}

}  // namespace
}  // namespace shapegauge
