// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/generator/skeleton.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

namespace shapegauge {

namespace {

constexpr double radians_per_degree = std::numbers::pi / 180;

Limb mirrored(Limb limb) {
  const Eigen::Vector3d plane(1, -1, 1);
  for (LimbNode& node : limb.nodes) node.position = node.position.cwiseProduct(plane);
  limb.flat_axis = limb.flat_axis.cwiseProduct(plane);
  // A rotation axis is a pseudo-vector: the same angle about the new axis is the mirrored motion.
  for (Joint& joint : limb.joints) {
    for (Hinge& h : joint.hinges) h.axis = -h.axis.cwiseProduct(plane);
  }
  return limb;
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

// Appends the bones of one limb; returns the bone of each of its segments.
std::vector<int> add_bones(const Limb& limb, int limb_index, int parent, std::vector<Bone>& bones) {
  std::vector<int> of_segment;
  const std::size_t before = bones.size();
  for (std::size_t segment = 0; segment + 1 < limb.nodes.size(); ++segment) {
    const Joint* joint = joint_at(limb, segment);
    if (segment == 0 || joint != nullptr) {
      Bone bone;
      bone.parent = bones.size() == before ? parent : static_cast<int>(bones.size()) - 1;
      bone.limb = limb_index;
      bone.index_in_limb = static_cast<int>(bones.size() - before);
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

std::string part_name(const Limb& limb) { return limb.side.empty() ? limb.kind : limb.kind + " " + limb.side; }

Hinge hinge(const Eigen::Vector3d& axis, double lower_degrees, double upper_degrees) {
  return {axis.normalized(), lower_degrees * radians_per_degree, upper_degrees * radians_per_degree};
}

Hinge hinge_towards(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double lower_degrees,
                    double upper_degrees) {
  return hinge(from.cross(to), lower_degrees, upper_degrees);
}

Hinge pitch_hinge(double lower_degrees, double upper_degrees) {
  return hinge(Eigen::Vector3d::UnitY(), lower_degrees, upper_degrees);
}

Hinge yaw_hinge(double lower_degrees, double upper_degrees) {
  return hinge(Eigen::Vector3d::UnitZ(), lower_degrees, upper_degrees);
}

Hinge roll_hinge(double lower_degrees, double upper_degrees) {
  return hinge(Eigen::Vector3d::UnitX(), lower_degrees, upper_degrees);
}

std::vector<Joint> joints_along(int first, int last, const std::vector<Hinge>& hinges) {
  std::vector<Joint> joints;
  for (int node = first; node <= last; ++node) joints.push_back({node, hinges});
  return joints;
}

int add_limb(Skeleton& skeleton, Limb limb) {
  skeleton.limbs.push_back(std::move(limb));
  return static_cast<int>(skeleton.limbs.size()) - 1;
}

int add_limb_pair(Skeleton& skeleton, const Limb& limb, bool parent_pair) {
  Limb left = limb;
  left.side = limb.side.empty() ? "left" : limb.side + " left";
  Limb right = mirrored(limb);
  right.side = limb.side.empty() ? "right" : limb.side + " right";
  if (parent_pair) ++right.parent;
  const int index = add_limb(skeleton, std::move(left));
  add_limb(skeleton, std::move(right));
  return index;
}

Limb turned(const Limb& limb, double degrees, const std::string& side) {
  const Eigen::AngleAxisd turn(degrees * radians_per_degree, Eigen::Vector3d::UnitZ());
  Limb result = limb;
  result.side = side;
  for (LimbNode& node : result.nodes) node.position = turn * node.position;
  result.flat_axis = turn * result.flat_axis;
  for (Joint& joint : result.joints) {
    for (Hinge& h : joint.hinges) h.axis = turn * h.axis;
  }
  return result;
}

BoneTree bone_tree_of(const Skeleton& skeleton) {
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
