// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/datasets/generator/pose.h"
#include "shapegauge/datasets/generator/skeleton.h"

namespace shapegauge {

/// Meshed body of a class in the rest pose, ready to be posed.
struct ArticulatedBody {
  Skeleton skeleton;
  RestPose rest;
  Triangles triangles;
  Eigen::VectorXi labels;   ///< limb of each triangle
  Eigen::MatrixXd weights;  ///< see bone_weights()
};

/// Meshes the skin of a skeleton with about `faces` triangles (within a fifth) and binds it to the bones.
ArticulatedBody make_body(const Skeleton& skeleton, int faces);

/// Draws an individual of the body's class in a random pose: random proportions, then poses until one is free of
/// self-intersections and degenerate triangles. The range of motion shrinks with each attempt. Throws
/// std::runtime_error if all attempts fail.
Shape draw_model(const ArticulatedBody& body, RandomNumbers& random);

}  // namespace shapegauge
