// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <string>
#include <vector>

namespace shapegauge {

/// Returns the distance from a point to a segment, in the plane or in space.
template <typename Point>
double distance_to_segment(const Point& point, const Point& start, const Point& end) {
  const Point along = end - start;
  const double t = std::clamp((point - start).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - start - t * along).norm();
}

/// Rotation axis of a joint with its range. The axis is a unit vector in the coordinates of the rest pose and moves
/// with the joint's parent.
struct Hinge {
  Eigen::Vector3d axis;  ///< unit vector; positive angles follow the right-hand rule
  double lower = 0;      ///< lower limit of the angle in radians, at most 0
  double upper = 0;      ///< upper limit of the angle in radians, at least 0
};

/// Point of a limb's centre line with the limb's radius.
struct LimbNode {
  Eigen::Vector3d position;  ///< position in the rest pose
  double radius = 0;         ///< radius of the limb at the node
};

/// Joint at a node of a limb; it moves the rest of the limb beyond the node and all limbs attached to it.
struct Joint {
  int node = 0;               ///< index in Limb::nodes of the node
  std::vector<Hinge> hinges;  ///< rotation axes; each moves with the axes before it
};

/// Part of a body: a tube of varying radius about a smooth curve through its nodes, with joints. A limb without joints
/// is rigid and moves with its parent.
struct Limb {
  std::string kind = {};  ///< name of the kind, such as "leg"; limbs of one kind share their proportions
  std::string side = {};  ///< distinguishes limbs of one kind, such as "left"; empty for a single limb
  int parent = -1;        ///< index in Skeleton::limbs of the limb to which the first node is attached; -1 for the root
  std::vector<LimbNode> nodes;     ///< nodes of the centre line, from the parent outwards; at least two
  std::vector<Joint> joints = {};  ///< joints at nodes of the limb, at most one per node
  bool curls = false;              ///< true if adjacent joints bend by similar angles, as in a tail
  double blend = 0.5;              ///< width of the smooth blend with other limbs, in radii of the first node
  Eigen::Vector3d flat_axis = Eigen::Vector3d::UnitZ();  ///< direction along which the cross-section is flattened
  double flatness = 1;  ///< thickness along flat_axis relative to the width; 1 for a circular cross-section
};

/// Articulated body in its rest pose: x forward, y to its left, z up; the limbs are its parts. A limb's parent precedes
/// it. In the rest pose, unconnected limbs are too far apart to blend.
struct Skeleton {
  std::string name;         ///< name of the class of bodies
  std::vector<Limb> limbs;  ///< limbs, each after its parent
};

/// Returns the part name of a limb: "kind", or "kind side" if the limb has a side.
std::string part_name(const Limb& limb);

/// Makes a hinge about an axis of any length, from lower <= 0 to upper >= 0 degrees.
Hinge hinge(const Eigen::Vector3d& axis, double lower_degrees, double upper_degrees);

/// Makes a hinge that turns the direction `from` towards the direction `to` for positive angles.
Hinge hinge_towards(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double lower_degrees, double upper_degrees);

/// Makes a hinge about y: positive angles lower the front and swing hanging limbs backwards.
Hinge pitch_hinge(double lower_degrees, double upper_degrees);
/// Makes a hinge about z: positive angles turn the front to the left.
Hinge yaw_hinge(double lower_degrees, double upper_degrees);
/// Makes a hinge about x: positive angles raise the left side.
Hinge roll_hinge(double lower_degrees, double upper_degrees);

/// Makes joints with the same hinges at the nodes of a limb with the indices first, ..., last.
std::vector<Joint> joints_along(int first, int last, const std::vector<Hinge>& hinges);

/// Adds a limb to a skeleton; returns the index of the limb.
int add_limb(Skeleton& skeleton, Limb limb);

/// Adds the limb as the left one and its mirror image in the plane y = 0 as the right one. The mirror image is attached
/// to the same parent or, with `parent_pair`, to the limb after the parent, which is the parent's mirror image. Returns
/// the index of the left limb.
int add_limb_pair(Skeleton& skeleton, const Limb& limb, bool parent_pair = false);

/// Returns a copy of the limb, rotated about the z axis, with the Limb::side `side`.
Limb turned(const Limb& limb, double degrees, const std::string& side);

/// Rigid segment of a limb, from one joint to the next.
struct Bone {
  int parent = -1;        ///< index in BoneTree::bones of the parent, which precedes this bone; -1 for the root
  int limb = 0;           ///< index in Skeleton::limbs of the limb that contains the bone
  int index_in_limb = 0;  ///< index among the bones of the limb, counted from the limb's first node
  Eigen::Vector3d joint = Eigen::Vector3d::Zero();       ///< position of the joint at the beginning of the bone
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< unit vector from the joint to the bone's end
  std::vector<Hinge> hinges;                             ///< rotation axes of the joint; empty if it does not bend
};

/// Bones of a skeleton. The first bone of every limb starts at the limb's first node.
struct BoneTree {
  std::vector<Bone> bones;                        ///< bones, each after its parent
  std::vector<std::vector<int>> bone_of_segment;  ///< bone index of each segment of each limb: [limb][segment]
};

/// Splits the limbs at their joints into bones, and attaches the first bone of every limb to the closest bone of the
/// parent limb.
BoneTree bone_tree_of(const Skeleton& skeleton);

}  // namespace shapegauge
