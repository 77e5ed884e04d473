// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>

#include "shapegauge/datasets/generator/mesh_implicit_surface.h"
#include "shapegauge/datasets/generator/pose.h"

namespace shapegauge {

namespace {

// A rod along x from -1 to 1 with a joint in the middle: two bones.
class BoneWeights : public testing::Test {
 protected:
  const Skeleton skeleton_{"",
                           {{.kind = "rod",
                             .nodes = {{{-1, 0, 0}, 0.2}, {{0, 0, 0}, 0.2}, {{1, 0, 0}, 0.2}},
                             .joints = {{1, {yaw_hinge(-30, 30)}}}}}};
  const ImplicitSurface surface_{skeleton_};
  const BoneTree tree_ = bone_tree_of(skeleton_);
  const Shape mesh_ = mesh_implicit_surface(surface_, 3000);
  const Eigen::MatrixXd weights_ = bone_weights(mesh_, surface_, tree_);
};

TEST_F(BoneWeights, AreNonNegativeAndSumToOne) {
  ASSERT_EQ(weights_.cols(), 2);
  EXPECT_GE(weights_.minCoeff(), 0);
  EXPECT_LT((weights_.rowwise().sum().array() - 1).abs().maxCoeff(), 1e-12);
}

TEST_F(BoneWeights, OnACylinderDecayExponentiallyFromTheJoint) {
  // On a long cylinder of radius r, -w'' + (w - p) / r^2 = 0 with p a step gives w = 1 - exp(-x / r) / 2 for x > 0.
  for (Eigen::Index i = 0; i < mesh_.vertices.rows(); ++i) {
    const double x = mesh_.vertices(i, 0);
    if (std::abs(x) > 0.7) continue;  // the ends are not those of an infinite cylinder
    const double decay = 0.5 * std::exp(-std::abs(x) / 0.2);
    EXPECT_NEAR(weights_(i, 1), x > 0 ? 1 - decay : decay, 0.03);
  }
}

TEST_F(BoneWeights, GiveFacesOfAllBonesOfALimbTheSameLabel) {
  EXPECT_EQ(limb_labels(mesh_, weights_, tree_), Eigen::VectorXi::Zero(mesh_.triangles.rows()));
}

TEST(LimbLabels, OfFacesAreTheLimbsWithTheLargestSkinningWeight) {
  const Shape mesh{.vertices = Points::Zero(4, 3), .triangles = Triangles{{0, 1, 2}, {1, 2, 3}}};
  BoneTree tree;
  tree.bones.resize(3);
  tree.bones[1].limb = 1;
  tree.bones[2].limb = 1;
  tree.bone_of_segment = {{0}, {1, 2}};
  const Eigen::MatrixXd weights{{1, 0, 0}, {0.5, 0.25, 0.25}, {0.6, 0.1, 0.3}, {0, 0.5, 0.5}};
  EXPECT_EQ(limb_labels(mesh, weights, tree), Eigen::Vector2i(0, 1));
}

Skeleton rod(bool curls) {
  return {"",
          {{.kind = "rod",
            .nodes = {{{0, 0, 0}, 0.2}, {{1, 0, 0}, 0.2}, {{2, 0, 0}, 0.2}, {{3, 0, 0}, 0.2}},
            .joints = joints_along(1, 2, {yaw_hinge(-40, 60)}),
            .curls = curls}}};
}

TEST(RandomPose, OfAmplitudeZeroIsTheRestPose) {
  const Skeleton s = rod(false);
  RandomNumbers random(1);
  for (const RigidMotion& motion : draw_pose(s, bone_tree_of(s), 0, random)) {
    EXPECT_EQ(motion.rotation.coeffs(), Eigen::Quaterniond::Identity().coeffs());
    EXPECT_EQ(motion.translation, Eigen::Vector3d::Zero());
  }
}

TEST(RandomPose, StaysWithinJointLimitsAndKeepsBonesConnected) {
  for (const bool curls : {false, true}) {
    const Skeleton s = rod(curls);
    const BoneTree tree = bone_tree_of(s);
    RandomNumbers random(2);
    for (int i = 0; i < 200; ++i) {
      const std::vector<RigidMotion> motions = draw_pose(s, tree, 1, random);
      for (std::size_t b = 1; b < motions.size(); ++b) {
        const Eigen::Vector3d& joint = tree.bones[b].joint;
        EXPECT_LT((motions[b].rotation * joint + motions[b].translation -
                   (motions[b - 1].rotation * joint + motions[b - 1].translation))
                      .norm(),
                  1e-14);
        const Eigen::AngleAxisd turn(motions[b - 1].rotation.conjugate() * motions[b].rotation);
        const double degrees = turn.angle() * turn.axis().z() * 180 / 3.14159265358979323846;
        EXPECT_GE(degrees, -40 - 1e-9);
        EXPECT_LE(degrees, 60 + 1e-9);
      }
    }
  }
}

TEST(Skinning, WithOneBoneIsItsRigidMotion) {
  RigidMotion motion;
  motion.rotation = Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, 3).normalized());
  motion.translation = {4, -5, 6};
  const Points points = Points::Random(50, 3);
  const Points moved = skin_points(points, Eigen::MatrixXd::Ones(50, 1), {motion});
  const Points expected =
      (points * motion.rotation.toRotationMatrix().transpose()).rowwise() + motion.translation.transpose();
  EXPECT_LT((moved - expected).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Skinning, WithTwoEqualWeightsRotatesByHalfTheAngle) {
  // Linear blending would pull the point towards the axis, by the cosine of half the angle between the two.
  RigidMotion bent;
  const Eigen::Vector3d joint(1, 2, 0);
  bent.rotation = Eigen::AngleAxisd(1.6, Eigen::Vector3d::UnitZ());
  bent.translation = joint - bent.rotation * joint;
  const Points point{{1, 2.5, 0.3}};
  const Points moved = skin_points(point, Eigen::MatrixXd::Constant(1, 2, 0.5), {RigidMotion(), bent});
  const Eigen::Vector3d expected =
      joint + Eigen::AngleAxisd(0.8, Eigen::Vector3d::UnitZ()) * Eigen::Vector3d(0, 0.5, 0.3);
  EXPECT_LT((moved.row(0).transpose() - expected).norm(), 1e-14);
}

TEST(LimbProportions, StretchLimbsByAFewPercentAndKeepJointsConnected) {
  Skeleton s;
  add_limb(s, {.kind = "body", .nodes = {{{0, 0, 0}, 0.5}, {{2, 0, 0}, 0.5}}});
  for (const double x : {0.5, 1.5}) {
    add_limb(s, {.kind = "leg", .parent = 0, .nodes = {{{x, 0, 0}, 0.2}, {{x, 0, -1}, 0.2}}});
  }
  RestPose rest;
  rest.tree = bone_tree_of(s);
  rest.points = Points{{2, 0, 0}, {0, 0.5, 0}, {0.5, 0, -1}, {1.5, 0, -1}};
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(4, 3);
  weights(0, 0) = weights(1, 0) = weights(2, 1) = weights(3, 2) = 1;
  RandomNumbers random(9);
  const RestPose drawn = draw_individual(s, rest, weights, random);
  const double body_length = drawn.points(0, 0) / 2;
  const double body_girth = drawn.points(1, 1) / 0.5;
  const double leg_length = -drawn.points(2, 2);
  for (const double factor : {body_length, body_girth, leg_length}) {
    EXPECT_NE(factor, 1);
    EXPECT_NEAR(factor, 1, 0.07);
  }
  EXPECT_GT(std::abs(body_girth - body_length), 1e-3) << "girth and length are drawn each by itself";
  EXPECT_NEAR(-drawn.points(3, 2), leg_length, 1e-15);  // both legs have the same proportions
  EXPECT_NEAR(drawn.tree.bones[1].joint.x(), 0.5 * body_length, 1e-15);
  EXPECT_NEAR(drawn.points(2, 0), 0.5 * body_length, 1e-15);
  EXPECT_NEAR(drawn.points(3, 0), 1.5 * body_length, 1e-15);
}

}  // namespace

}  // namespace shapegauge
