#pragma once

#include <Eigen/Core>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/experiments/generator/bones.h"
#include "shapegauge/experiments/generator/skeleton.h"
#include "shapegauge/random/random_numbers.h"

namespace shapegauge {

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
