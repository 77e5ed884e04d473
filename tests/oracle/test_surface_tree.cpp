#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <optional>
#include <rapidcheck/gtest.h>

#include "tests/core/spatial/random_triangle.h"
#include "tests/oracle/surface_tree.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

TEST(SurfaceTree, CannotSayWhereARayMeetsACorner) {
  const SurfaceTree tree(test::box({2, 2, 2}, 1));
  const Eigen::Vector3d diagonal = Eigen::Vector3d(1, 1, 1).normalized();
  EXPECT_FALSE(tree.ray_parity(-3 * diagonal, diagonal).has_value());
}

/// Odd inside and even outside, however parts overlap; the balance says how often one is inside.
RC_GTEST_PROP(SurfaceTree, ParityTellsTheInsideOfClosedMeshes, ()) {
  const Eigen::Vector3d centre = 0.3 * random_point();
  const Shape ball = test::transformed(test::sphere(0.5, 3), 1, test::rotation(3), centre);
  const Shape other = test::sphere(0.4, 2);
  const SurfaceTree tree(test::joined({ball, other}));
  const Eigen::Vector3d x = random_point();
  const double to_ball = (x - centre).norm();
  const double to_other = x.norm();
  // Between a sphere and its mesh nothing is known; the faces lie less than 1 and 2 % of the radius below it.
  RC_PRE((to_ball > 0.5 || to_ball < 0.49) && (to_other > 0.4 || to_other < 0.37));
  const int inside = (to_ball < 0.5 ? 1 : 0) + (to_other < 0.4 ? 1 : 0);
  int answered = 0;
  for (int i = 0; i < 5; ++i) {
    const Eigen::Vector3d towards = random_point();
    if (!(towards.norm() > 0.01)) continue;
    const std::optional<RayParity> parity = tree.ray_parity(x, towards.normalized());
    if (!parity) continue;
    ++answered;
    RC_ASSERT(parity->balance == inside);
    RC_ASSERT((parity->count - inside) % 2 == 0);
    RC_ASSERT(parity->count >= inside);
  }
  RC_ASSERT(answered > 0);
}

}  // namespace
}  // namespace shapegauge
