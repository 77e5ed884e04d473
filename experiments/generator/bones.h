#pragma once

#include <Eigen/Core>
#include <vector>

#include "shapegauge/experiments/generator/skeleton.h"

namespace shapegauge {

/// A stiff stretch of a limb, from one joint to the next.
struct Bone {
  int parent = -1;  ///< index of the bone that carries this one; parents come first; -1: the root
  int limb = 0;     ///< the limb that it belongs to
  int place = 0;    ///< how many bones of its limb come before it
  Eigen::Vector3d joint = Eigen::Vector3d::Zero();       ///< where it begins and turns
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< unit vector from there to its end
  std::vector<Hinge> hinges;                             ///< empty where the joint does not bend
};

/// The bones of a skeleton. The first bone of every limb is at the limb's first node.
struct BoneTree {
  std::vector<Bone> bones;
  std::vector<std::vector<int>> bone_of_segment;  ///< by limb, then by segment of the limb
};

/// Splits the limbs at their joints and hangs every limb from the bone of its parent that is closest to its first node.
BoneTree bones_of(const Skeleton& skeleton);

}  // namespace shapegauge
