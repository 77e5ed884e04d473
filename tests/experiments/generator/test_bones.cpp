#include <gtest/gtest.h>

#include "shapegauge/experiments/generator/bones.h"
#include "shapegauge/experiments/generator/classes/class_skeletons.h"

namespace shapegauge {
namespace {

TEST(Bones, LimbsSplitAtTheirJointsAndHangFromTheClosestBone) {
  Skeleton s;
  const int spine = add_limb(s, {.kind = "spine",
                                 .nodes = {{{0, 0, 0}, 1}, {{1, 0, 0}, 1}, {{2, 0, 0}, 1}, {{3, 0, 0}, 1}},
                                 .joints = {{2, {yaw(-10, 10)}}}});
  add_limb(s, {.kind = "leg", .parent = spine, .nodes = {{{2.5, 0, -1}, 0.2}, {{2.5, 0, -2}, 0.2}}});
  add_limb(s, {.kind = "ear", .parent = spine, .nodes = {{{0.5, 0, 1}, 0.2}, {{0.5, 0, 2}, 0.2}}});
  const BoneTree tree = bones_of(s);
  ASSERT_EQ(tree.bones.size(), 4U);
  EXPECT_EQ(tree.bone_of_segment, (std::vector<std::vector<int>>{{0, 0, 1}, {2}, {3}}));
  EXPECT_EQ(tree.bones[0].parent, -1);
  EXPECT_EQ(tree.bones[1].parent, 0);
  EXPECT_EQ(tree.bones[2].parent, 1);
  EXPECT_EQ(tree.bones[3].parent, 0);
  EXPECT_EQ(tree.bones[1].place, 1);
  EXPECT_EQ(tree.bones[1].joint, Eigen::Vector3d(2, 0, 0));
  EXPECT_EQ(tree.bones[1].hinges.size(), 1U);
  EXPECT_TRUE(tree.bones[3].hinges.empty());
  EXPECT_EQ(tree.bones[2].direction, Eigen::Vector3d(0, 0, -1));
}

TEST(Bones, OfEveryClassHaveTheirParentsBeforeThem) {
  for (std::size_t c = 0; c < class_count(); ++c) {
    const Skeleton skeleton = class_skeleton(c);
    SCOPED_TRACE(skeleton.name);
    const BoneTree tree = bones_of(skeleton);
    for (std::size_t b = 0; b < tree.bones.size(); ++b) {
      EXPECT_LT(tree.bones[b].parent, static_cast<int>(b));
      EXPECT_EQ(tree.bones[b].parent < 0, b == 0);
      for (const Hinge& h : tree.bones[b].hinges) {
        EXPECT_LE(h.lower, 0);
        EXPECT_GE(h.upper, 0);
        EXPECT_NEAR(h.axis.norm(), 1, 1e-12);
      }
    }
    for (std::size_t i = 0; i < skeleton.limbs.size(); ++i) EXPECT_LT(skeleton.limbs[i].parent, static_cast<int>(i));
  }
}

}  // namespace
}  // namespace shapegauge
