#include <cmath>
#include <gtest/gtest.h>

#include "shapegauge/experiments/generator/pose.h"

namespace shapegauge {
namespace {

Skeleton rod(bool curls) {
  return {"",
          {{.kind = "rod",
            .nodes = {{{0, 0, 0}, 0.2}, {{1, 0, 0}, 0.2}, {{2, 0, 0}, 0.2}, {{3, 0, 0}, 0.2}},
            .joints = joints_along(1, 2, {yaw(-40, 60)}),
            .curls = curls}}};
}

TEST(Pose, OfAmplitudeZeroIsTheRestPose) {
  const Skeleton s = rod(false);
  RandomNumbers random(1);
  for (const RigidMotion& motion : draw_pose(s, bones_of(s), 0, random)) {
    EXPECT_EQ(motion.rotation.coeffs(), Eigen::Quaterniond::Identity().coeffs());
    EXPECT_EQ(motion.translation, Eigen::Vector3d::Zero());
  }
}

TEST(Pose, StaysWithinTheLimitsAndKeepsBonesConnected) {
  for (const bool curls : {false, true}) {
    const Skeleton s = rod(curls);
    const BoneTree tree = bones_of(s);
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

TEST(Skinned, WithOneBoneIsItsRigidMotion) {
  RigidMotion motion;
  motion.rotation = Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, 3).normalized());
  motion.translation = {4, -5, 6};
  const Points points = Points::Random(50, 3);
  const Points moved = skinned(points, Eigen::MatrixXd::Ones(50, 1), {motion});
  const Points expected =
      (points * motion.rotation.toRotationMatrix().transpose()).rowwise() + motion.translation.transpose();
  EXPECT_LT((moved - expected).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Skinned, HalfwayBetweenTwoRotationsAboutAJointIsTheMiddleRotation) {
  // Linear blending would pull the point towards the axis, by the cosine of half the angle between the two.
  RigidMotion bent;
  const Eigen::Vector3d joint(1, 2, 0);
  bent.rotation = Eigen::AngleAxisd(1.6, Eigen::Vector3d::UnitZ());
  bent.translation = joint - bent.rotation * joint;
  Points point(1, 3);
  point << 1, 2.5, 0.3;
  const Points moved = skinned(point, Eigen::MatrixXd::Constant(1, 2, 0.5), {RigidMotion(), bent});
  const Eigen::Vector3d expected =
      joint + Eigen::AngleAxisd(0.8, Eigen::Vector3d::UnitZ()) * Eigen::Vector3d(0, 0.5, 0.3);
  EXPECT_LT((moved.row(0).transpose() - expected).norm(), 1e-14);
}

}  // namespace
}  // namespace shapegauge
