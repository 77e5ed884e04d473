#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/datasets/generator/implicit_surface.h"
#include "shapegauge/datasets/generator/skeleton.h"

namespace shapegauge {

/// How much every bone moves every vertex: a row a vertex, a column a bone, rows summing to 1. The bones' influence
/// spreads over the surface as heat does (Baran and Popovic, "Automatic rigging and animation of 3D characters", 2007,
/// section 4), across joints by about the limb's radius there. The mesh is one of the surface in the rest pose.
Eigen::MatrixXd bone_weights(const Shape& mesh, const ImplicitSurface& surface, const BoneTree& tree);

/// The limb that each triangle belongs to: the one whose bones have most weight at its corners.
Eigen::VectorXi limb_labels(const Shape& mesh, const Eigen::MatrixXd& weights, const BoneTree& tree);

/// x -> rotation x + translation.
struct RigidMotion {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
};

/// Bends every joint at random within its limits, scaled by amplitude (0: the rest pose, 1: the full range). Returns
/// how each bone moves out of the rest pose. The joints of a limb that curls follow one smooth bend.
std::vector<RigidMotion> draw_pose(const Skeleton& skeleton, const BoneTree& tree, double amplitude,
                                   RandomNumbers& random);

/// Moves the points with their bones: dual quaternion blending (Kavan et al., "Geometric skinning with approximate dual
/// quaternion blending", 2008), which does not collapse at joints. `weights`: a row a point, a column a bone.
Points skinned(const Points& points, const Eigen::MatrixXd& weights, const std::vector<RigidMotion>& motions);

/// A body's points and bones in the rest pose.
struct RestPose {
  Points points;
  BoneTree tree;
};

/// An individual of a class: every kind of limb gets a length and a girth of its own, a few percent off those of the
/// class, the same for all limbs of the kind. `weights` are the class's bone weights.
RestPose draw_individual(const Skeleton& skeleton, const RestPose& rest, const Eigen::MatrixXd& weights,
                         RandomNumbers& random);

}  // namespace shapegauge
