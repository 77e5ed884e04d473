#include "shapegauge/experiments/generator/skeleton.h"

#include <Eigen/Geometry>
#include <numbers>
#include <utility>

namespace shapegauge {

namespace {

constexpr double radians_per_degree = std::numbers::pi / 180;

Limb mirrored(Limb limb) {
  const Eigen::Vector3d plane(1, -1, 1);
  for (LimbNode& node : limb.nodes) node.position = node.position.cwiseProduct(plane);
  limb.flat_axis = limb.flat_axis.cwiseProduct(plane);
  // An axis of rotation is a pseudo-vector: the same angle about the new axis is the mirror image of the motion.
  for (Joint& joint : limb.joints) {
    for (Hinge& h : joint.hinges) h.axis = -h.axis.cwiseProduct(plane);
  }
  return limb;
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

Hinge pitch(double lower_degrees, double upper_degrees) {
  return hinge(Eigen::Vector3d::UnitY(), lower_degrees, upper_degrees);
}

Hinge yaw(double lower_degrees, double upper_degrees) {
  return hinge(Eigen::Vector3d::UnitZ(), lower_degrees, upper_degrees);
}

Hinge roll(double lower_degrees, double upper_degrees) {
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

}  // namespace shapegauge
