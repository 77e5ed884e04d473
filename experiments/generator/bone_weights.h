#pragma once

#include <Eigen/Core>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/experiments/generator/bones.h"
#include "shapegauge/experiments/generator/implicit_surface.h"

namespace shapegauge {

/// How much every bone moves every vertex: a row a vertex, a column a bone, rows summing to 1. The bones' influence
/// spreads over the surface as heat does (Baran and Popovic, "Automatic rigging and animation of 3D characters", 2007,
/// section 4), across joints by about the limb's radius there. The mesh is one of the surface in the rest pose.
Eigen::MatrixXd bone_weights(const Shape& mesh, const ImplicitSurface& surface, const BoneTree& tree);

/// The limb that each triangle belongs to: the one whose bones have most weight at its corners.
Eigen::VectorXi limb_labels(const Shape& mesh, const Eigen::MatrixXd& weights, const BoneTree& tree);

}  // namespace shapegauge
