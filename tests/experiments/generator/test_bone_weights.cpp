#include <gtest/gtest.h>

#include "shapegauge/experiments/generator/bone_weights.h"
#include "shapegauge/experiments/generator/mesh_implicit_surface.h"

namespace shapegauge {
namespace {

// A rod along x from -1 to 1 with a joint in the middle: two bones.
class BoneWeights : public testing::Test {
 protected:
  const Skeleton skeleton_{"",
                           {{.kind = "rod",
                             .nodes = {{{-1, 0, 0}, 0.2}, {{0, 0, 0}, 0.2}, {{1, 0, 0}, 0.2}},
                             .joints = {{1, {yaw(-30, 30)}}}}}};
  const ImplicitSurface surface_{skeleton_};
  const BoneTree tree_ = bones_of(skeleton_);
  const Shape mesh_ = mesh_implicit_surface(surface_, 3000);
  const Eigen::MatrixXd weights_ = bone_weights(mesh_, surface_, tree_);
};

TEST_F(BoneWeights, SumToOneAndAreNotNegative) {
  ASSERT_EQ(weights_.cols(), 2);
  EXPECT_GE(weights_.minCoeff(), 0);
  EXPECT_LT((weights_.rowwise().sum().array() - 1).abs().maxCoeff(), 1e-12);
}

TEST_F(BoneWeights, DecayFromTheJointAsHeatDoesOnACylinder) {
  // On a long cylinder of radius r, -w'' + (w - p) / r^2 = 0 with p a step gives w = 1 - exp(-x / r) / 2 for x > 0.
  for (Eigen::Index i = 0; i < mesh_.vertices.rows(); ++i) {
    const double x = mesh_.vertices(i, 0);
    if (std::abs(x) > 0.7) continue;  // the ends are not those of an infinite cylinder
    const double decay = 0.5 * std::exp(-std::abs(x) / 0.2);
    EXPECT_NEAR(weights_(i, 1), x > 0 ? 1 - decay : decay, 0.03);
  }
}

TEST_F(BoneWeights, LabelsAreLimbsNotBones) {
  EXPECT_EQ(limb_labels(mesh_, weights_, tree_), Eigen::VectorXi::Zero(mesh_.triangles.rows()));
}

TEST(LimbLabels, GoToTheLimbWithMostWeight) {
  Shape mesh;
  mesh.vertices = Points::Zero(4, 3);
  mesh.triangles.resize(2, 3);
  mesh.triangles << 0, 1, 2, 1, 2, 3;
  BoneTree tree;
  tree.bones.resize(3);
  tree.bones[1].limb = 1;
  tree.bones[2].limb = 1;
  tree.bone_of_segment = {{0}, {1, 2}};
  Eigen::MatrixXd weights(4, 3);
  weights << 1, 0, 0, 0.5, 0.25, 0.25, 0.6, 0.1, 0.3, 0, 0.5, 0.5;
  EXPECT_EQ(limb_labels(mesh, weights, tree), Eigen::Vector2i(0, 1));
}

}  // namespace
}  // namespace shapegauge
