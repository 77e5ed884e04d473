#include "shapegauge/experiments/generator/bones.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace shapegauge {

namespace {

double distance_to_segment(const Eigen::Vector3d& point, const Eigen::Vector3d& start, const Eigen::Vector3d& end) {
  const Eigen::Vector3d along = end - start;
  const double t = std::clamp((point - start).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - start - t * along).norm();
}

std::size_t closest_segment(const Limb& limb, const Eigen::Vector3d& point) {
  std::size_t closest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t segment = 0; segment + 1 < limb.nodes.size(); ++segment) {
    const double distance = distance_to_segment(point, limb.nodes[segment].position, limb.nodes[segment + 1].position);
    if (distance < least) {
      least = distance;
      closest = segment;
    }
  }
  return closest;
}

const Joint* joint_at(const Limb& limb, std::size_t node) {
  const auto found = std::find_if(limb.joints.begin(), limb.joints.end(),
                                  [node](const Joint& joint) { return static_cast<std::size_t>(joint.node) == node; });
  return found == limb.joints.end() ? nullptr : &*found;
}

// Appends the bones of one limb; gives the bone of each of its segments.
std::vector<int> add_bones(const Limb& limb, int limb_index, int parent, std::vector<Bone>& bones) {
  std::vector<int> of_segment;
  const std::size_t before = bones.size();
  for (std::size_t segment = 0; segment + 1 < limb.nodes.size(); ++segment) {
    const Joint* joint = joint_at(limb, segment);
    if (segment == 0 || joint != nullptr) {
      Bone bone;
      bone.parent = bones.size() == before ? parent : static_cast<int>(bones.size()) - 1;
      bone.limb = limb_index;
      bone.place = static_cast<int>(bones.size() - before);
      bone.joint = limb.nodes[segment].position;
      if (joint != nullptr) bone.hinges = joint->hinges;
      bones.push_back(bone);
    }
    bones.back().direction = (limb.nodes[segment + 1].position - bones.back().joint).normalized();
    of_segment.push_back(static_cast<int>(bones.size()) - 1);
  }
  return of_segment;
}

}  // namespace

BoneTree bones_of(const Skeleton& skeleton) {
  BoneTree tree;
  for (std::size_t i = 0; i < skeleton.limbs.size(); ++i) {
    const Limb& limb = skeleton.limbs[i];
    int parent = -1;
    if (limb.parent >= 0) {
      const auto parent_limb = static_cast<std::size_t>(limb.parent);
      const std::size_t segment = closest_segment(skeleton.limbs[parent_limb], limb.nodes.front().position);
      parent = tree.bone_of_segment[parent_limb][segment];
    }
    tree.bone_of_segment.push_back(add_bones(limb, static_cast<int>(i), parent, tree.bones));
  }
  return tree;
}

}  // namespace shapegauge
