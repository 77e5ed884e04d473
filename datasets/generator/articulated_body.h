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
  Skeleton skeleton;
  RestPose rest;
  Triangles triangles;
  Eigen::VectorXi labels;   ///< index of the limb of each triangle
  Eigen::MatrixXd weights;  ///< skinning weights of bone_weights(): one row per vertex, one column per bone
};

/// Meshes the skin of a skeleton with about `faces` triangles (within a fifth) and binds it to the bones.
ArticulatedBody make_body(const Skeleton& skeleton, int faces);

/// Draws an individual of the body's class in a random pose: random proportions, then poses until one is free of
/// self-intersections and degenerate triangles. The range of motion shrinks with each attempt. Throws
/// std::runtime_error if all attempts fail.
Shape draw_model(const ArticulatedBody& body, RandomNumbers& random);

}  // namespace shapegauge
