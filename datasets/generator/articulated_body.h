// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/datasets/generator/pose.h"
#include "shapegauge/datasets/generator/skeleton.h"

namespace shapegauge {

/// Skinned mesh of a class of articulated bodies in the rest pose: skeleton, surface and skinning weights.
struct ArticulatedBody {
  Skeleton skeleton;        ///< limbs and joints of the class of bodies
  RestPose rest;            ///< vertices of the surface and bones, in the rest pose
  Triangles triangles;      ///< vertex indices of the triangles
  Eigen::VectorXi labels;   ///< per triangle: index of its limb in Skeleton::limbs
  Eigen::MatrixXd weights;  ///< skinning weights of bone_weights(): one row per vertex, one column per bone
};

/// Meshes the skin of a skeleton with about `faces` triangles (within a fifth) and binds it to the bones.
ArticulatedBody make_articulated_body(const Skeleton& skeleton, int faces);

/// Draws a random individual of the body's class: random proportions, then random poses until the mesh in one of them
/// is free of self-intersections and degenerate triangles. The range of motion shrinks with each attempt. Throws
/// std::runtime_error if all attempts fail.
Shape draw_model(const ArticulatedBody& body, RandomNumbers& random);

}  // namespace shapegauge
