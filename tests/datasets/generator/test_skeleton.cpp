// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <numbers>

#include "shapegauge/datasets/generator/class_skeletons.h"
#include "shapegauge/datasets/generator/skeleton.h"

namespace shapegauge {

namespace {

Limb arm() {
  return {.kind = "arm",
          .nodes = {{{0, 1, 0}, 0.2}, {{0, 2, 0.5}, 0.1}},
          .joints = {{0, {hinge({0.3, 0.5, -0.8}, -10, 40)}}},
          .flat_axis = {0.1, 0.2, 0.9}};
}

TEST(Skeleton, HingeAtItsUpperLimitTurnsTheFirstDirectionIntoTheSecond) {
  const Hinge h = hinge_towards({1, 0, 0}, {0, 0, 1}, -30, 90);
  EXPECT_NEAR(h.lower, -std::numbers::pi / 6, 1e-15);
  const Eigen::Vector3d turned_direction = Eigen::AngleAxisd(h.upper, h.axis) * Eigen::Vector3d(1, 0, 0);
  EXPECT_LT((turned_direction - Eigen::Vector3d(0, 0, 1)).norm(), 1e-15);
}

TEST(Skeleton, LimbPairIsMirroredAtRestAndInMotion) {
  Skeleton s;
  const int left = add_limb_pair(s, arm());
  ASSERT_EQ(s.limbs.size(), 2U);
  EXPECT_EQ(left, 0);
  EXPECT_EQ(part_name(s.limbs[0]), "arm left");
  EXPECT_EQ(part_name(s.limbs[1]), "arm right");
  const Eigen::Vector3d mirror(1, -1, 1);
  const auto tip_moved = [](const Limb& limb) {
    const Hinge& h = limb.joints[0].hinges[0];
    const Eigen::Vector3d root = limb.nodes[0].position;
    return Eigen::Vector3d(root + Eigen::AngleAxisd(h.upper, h.axis) * (limb.nodes[1].position - root));
  };
  EXPECT_LT((tip_moved(s.limbs[0]).cwiseProduct(mirror) - tip_moved(s.limbs[1])).norm(), 1e-15);
  EXPECT_EQ(s.limbs[1].flat_axis, Eigen::Vector3d(0.1, -0.2, 0.9));
}

TEST(Skeleton, ChildrenOfALimbPairAttachToTheLimbOnTheirSide) {
  Skeleton s;
  const int upper = add_limb_pair(s, arm());
  Limb claw = arm();
  claw.parent = upper;
  const int lower = add_limb_pair(s, claw, true);
  EXPECT_EQ(s.limbs[static_cast<std::size_t>(lower)].parent, upper);
  EXPECT_EQ(s.limbs[static_cast<std::size_t>(lower) + 1].parent, upper + 1);
}

TEST(Skeleton, RotatedLimbHasRotatedNodesAndHinges) {
  const Limb limb = turned(arm(), 90, "2");
  EXPECT_EQ(part_name(limb), "arm 2");
  EXPECT_LT((limb.nodes[0].position - Eigen::Vector3d(-1, 0, 0)).norm(), 1e-15);
  const Eigen::Vector3d axis = Eigen::Vector3d(-0.5, 0.3, -0.8).normalized();
  EXPECT_LT((limb.joints[0].hinges[0].axis - axis).norm(), 1e-15);
}

TEST(SkeletonBones, AreSplitAtJointsAndAttachedToTheClosestBone) {
  Skeleton s;
  const int spine = add_limb(s, {.kind = "spine",
                                 .nodes = {{{0, 0, 0}, 1}, {{1, 0, 0}, 1}, {{2, 0, 0}, 1}, {{3, 0, 0}, 1}},
                                 .joints = {{2, {yaw_hinge(-10, 10)}}}});
  add_limb(s, {.kind = "leg", .parent = spine, .nodes = {{{2.5, 0, -1}, 0.2}, {{2.5, 0, -2}, 0.2}}});
  add_limb(s, {.kind = "ear", .parent = spine, .nodes = {{{0.5, 0, 1}, 0.2}, {{0.5, 0, 2}, 0.2}}});
  const BoneTree tree = bone_tree_of(s);
  ASSERT_EQ(tree.bones.size(), 4U);
  EXPECT_EQ(tree.bone_of_segment, (std::vector<std::vector<int>>{{0, 0, 1}, {2}, {3}}));
  EXPECT_EQ(tree.bones[0].parent, -1);
  EXPECT_EQ(tree.bones[1].parent, 0);
  EXPECT_EQ(tree.bones[2].parent, 1);
  EXPECT_EQ(tree.bones[3].parent, 0);
  EXPECT_EQ(tree.bones[1].index_in_limb, 1);
  EXPECT_EQ(tree.bones[1].joint, Eigen::Vector3d(2, 0, 0));
  EXPECT_EQ(tree.bones[1].hinges.size(), 1U);
  EXPECT_TRUE(tree.bones[3].hinges.empty());
  EXPECT_EQ(tree.bones[2].direction, Eigen::Vector3d(0, 0, -1));
}

TEST(SkeletonBones, OfEveryClassAreListedAfterTheirParents) {
  for (std::size_t c = 0; c < articulated_class_count(); ++c) {
    const Skeleton skeleton = class_skeleton(c);
    SCOPED_TRACE(skeleton.name);
    const BoneTree tree = bone_tree_of(skeleton);
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
