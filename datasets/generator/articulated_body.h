#pragma once

#include <Eigen/Core>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/datasets/generator/pose.h"
#include "shapegauge/datasets/generator/skeleton.h"

namespace shapegauge {

/// A class's body in the rest pose, meshed, ready to be posed.
struct ArticulatedBody {
  Skeleton skeleton;
  RestPose rest;
  Triangles triangles;
  Eigen::VectorXi labels;   ///< for each triangle, the limb that it belongs to
  Eigen::MatrixXd weights;  ///< see bone_weights
};

/// Meshes a skeleton's skin with about so many triangles (within a fifth) and attaches it to the bones.
ArticulatedBody make_body(const Skeleton& skeleton, int faces);

/// An individual of the body's class in a pose: proportions drawn at random, then poses until one is free of
/// self-intersections and of degenerate triangles, the range of motion shrinking from draw to draw. Throws
/// std::runtime_error where none of them is.
Shape draw_model(const ArticulatedBody& body, RandomNumbers& random);

}  // namespace shapegauge
