#include <gtest/gtest.h>

#include "shapegauge/core/spatial/exposed_direction.h"

namespace shapegauge {
namespace {

TEST(ExposedDirection, OfAPointInAGridIsThePlanesNormal) {
  Shape grid{Points(441, 3), {}};
  for (int i = 0; i < 441; ++i) grid.vertices.row(i) << (i / 21 - 10) / 30.0, (i % 21 - 10) / 30.0, 0;
  const TriangleBVH tree(grid);
  const OffsetExterior exterior(tree, bounding_box(grid), 0.05, false);
  for (const double side : {1.0, -1.0}) {
    for (const double tilt : {0.0, 0.2, 0.5}) {
      const Eigen::Vector3d axis = Eigen::Vector3d(tilt, tilt / 3, side).normalized();
      const auto middle = middle_of_exposed(exterior, {0, 0, 0}, axis);
      ASSERT_TRUE(middle) << tilt;
      EXPECT_NEAR(middle->norm(), 1, 1e-12);
      EXPECT_GT(middle->dot(Eigen::Vector3d(0, 0, side)), std::cos(0.1)) << tilt;
    }
  }
  EXPECT_FALSE(middle_of_exposed(exterior, {0, 0, 0}, {1, 0, 0}) &&
               std::abs(middle_of_exposed(exterior, {0, 0, 0}, {1, 0, 0})->z()) < 0.5);
}

TEST(ExposedDirection, OfALonePointIsTheAxis) {
  Shape points{Points(2, 3), {}};
  points.vertices << 0.5, 0, 0, -0.5, 0, 0;
  const TriangleBVH tree(points);
  const OffsetExterior exterior(tree, bounding_box(points), 0.05, false);
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, 3).normalized();
  const auto middle = middle_of_exposed(exterior, {0.5, 0, 0}, axis);
  ASSERT_TRUE(middle);
  EXPECT_LT((*middle - axis).norm(), 1e-9);
}

}  // namespace
}  // namespace shapegauge
