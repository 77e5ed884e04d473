#include <gtest/gtest.h>

#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/segmentation/thick_surface.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

TEST(FacingOutward, TurnsClosedMeshesThatFaceInward) {
  const Shape box = test::box({1, 2, 3}, 1);
  ASSERT_NEAR(signed_volume(box), 6, 1e-12);
  EXPECT_EQ(facing_outward(box).triangles, box.triangles);
  Shape inside_out = box;
  inside_out.triangles.col(1).swap(inside_out.triangles.col(2));
  EXPECT_NEAR(signed_volume(facing_outward(inside_out)), 6, 1e-12);
}

TEST(FacingOutward, LeavesOpenMeshesAlone) {
  Shape open = test::box({1, 2, 3}, 1);
  open.triangles.col(1).swap(open.triangles.col(2));
  open.triangles.conservativeResize(open.triangles.rows() - 1, Eigen::NoChange);
  EXPECT_EQ(facing_outward(open).triangles, open.triangles);
}

}  // namespace
}  // namespace shapegauge
