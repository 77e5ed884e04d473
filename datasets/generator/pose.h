// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/datasets/generator/implicit_surface.h"
#include "shapegauge/datasets/generator/skeleton.h"

namespace shapegauge {

/// Computes skinning weights: one row per vertex, one column per bone, rows sum to 1. The influence of bones diffuses
/// over the surface like heat (Baran and Popovic, "Automatic rigging and animation of 3D characters", 2007, section 4),
/// across joints by about the local radius of the limb. The mesh must be that of the surface in the rest pose.
Eigen::MatrixXd bone_weights(const Shape& mesh, const ImplicitSurface& surface, const BoneTree& tree);

/// Returns the index of the limb of each triangle: the limb with the largest sum of bone weights at the corners.
Eigen::VectorXi limb_labels(const Shape& mesh, const Eigen::MatrixXd& weights, const BoneTree& tree);

/// Rigid motion x -> rotation x + translation.
struct RigidMotion {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< rotation as a unit quaternion
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();         ///< translation after the rotation
};

/// Draws random joint angles within their limits, scaled by `amplitude` (0: the rest pose, 1: the full range). Returns
/// the motion of each bone from the rest pose. The joints of a limb that curls follow one smooth bend.
std::vector<RigidMotion> draw_pose(const Skeleton& skeleton, const BoneTree& tree, double amplitude,
                                   RandomNumbers& random);

/// Deforms points with their bones by dual quaternion blending (Kavan et al., "Geometric skinning with approximate dual
/// quaternion blending", 2008), which avoids collapsing joints. `weights` has one row per point, one column per bone;
/// `motions` one entry per bone.
Points skin_points(const Points& points, const Eigen::MatrixXd& weights, const std::vector<RigidMotion>& motions);

/// Points and bones of a body in the rest pose.
struct RestPose {
  Points points;  ///< vertices of the surface
  BoneTree tree;  ///< bones of the skeleton
};

/// Draws an individual of a class: scales the length and the girth of every kind of limb by random factors from 0.93 to
/// 1.07, the same for all limbs of the kind. `weights` are the class's skinning weights.
RestPose draw_individual(const Skeleton& skeleton, const RestPose& rest, const Eigen::MatrixXd& weights,
                         RandomNumbers& random);

}  // namespace shapegauge
