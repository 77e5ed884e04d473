#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/experiments/generator/bones.h"
#include "shapegauge/experiments/generator/skeleton.h"
#include "shapegauge/random/random_numbers.h"

namespace shapegauge {

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

}  // namespace shapegauge
