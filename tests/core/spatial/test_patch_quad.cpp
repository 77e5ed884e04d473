#include <cmath>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "shapegauge/core/spatial/patch_quad.h"
#include "tests/core/spatial/random_triangle.h"

namespace shapegauge {
namespace {

TEST(PatchQuad, HasItsPointsOnTheSphereWhereTheFaceSays) {
  for (int face = 0; face < 6; ++face) {
    const PatchQuad quad = patch_quad(2, face, 0.25, -0.5, 0.25);
    const int axis = face % 3;
    for (int lane = 0; lane < 13; ++lane) {
      const Eigen::Vector3d x = quad.point(lane);
      EXPECT_NEAR(x.norm(), 2, 1e-6);
      EXPECT_EQ(x[axis] > 0, face < 3);
    }
    for (std::size_t quarter = 0; quarter < 4; ++quarter) {
      const Eigen::Vector3d middle = quad.point(PatchQuad::middle_lane[quarter]);
      const double u = middle[(axis + 1) % 3] / std::abs(middle[axis]);
      const double v = middle[(axis + 2) % 3] / std::abs(middle[axis]);
      EXPECT_NEAR(u, 0.25 + (quarter % 2 == 0 ? -0.125 : 0.125), 1e-6);
      EXPECT_NEAR(v, -0.5 + (quarter < 2 ? -0.125 : 0.125), 1e-6);
      for (const int corner : PatchQuad::corner_lanes[quarter]) {
        const Eigen::Vector3d x = quad.point(corner);
        EXPECT_NEAR(std::abs(x[(axis + 1) % 3] / std::abs(x[axis]) - u), 0.125, 1e-6);
        EXPECT_NEAR(std::abs(x[(axis + 2) % 3] / std::abs(x[axis]) - v), 0.125, 1e-6);
      }
    }
  }
}

RC_GTEST_PROP(PatchQuad, GivesTheDistancesOfTheClosestPoints, ()) {
  const Triangle triangle = random_triangle();
  const double half = 1.0 / (1 << *rc::gen::inRange(0, 6));
  const PatchQuad quad = patch_quad(1, *rc::gen::inRange(0, 6), 0, 0, half);
  const auto distances = squared_distances(quad, triangle);
  for (int lane = 0; lane < 13; ++lane) {
    const Eigen::Vector3d x = quad.point(lane);
    const double expected = (closest_point(triangle, x) - x).squaredNorm();
    RC_ASSERT(std::abs(static_cast<double>(distances[static_cast<std::size_t>(lane)]) - expected) <= 1e-5);
  }
}

}  // namespace
}  // namespace shapegauge
