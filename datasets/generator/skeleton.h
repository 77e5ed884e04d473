#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <string>
#include <vector>

namespace shapegauge {

/// The distance from a point to a segment, in the plane or in space.
template <typename Point>
double distance_to_segment(const Point& point, const Point& start, const Point& end) {
  const Point along = end - start;
  const double t = std::clamp((point - start).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - start - t * along).norm();
}

/// One axis that a joint turns about, and how far. The axis is a unit vector in the coordinates of the rest pose; the
/// joint's parent carries it along.
struct Hinge {
  Eigen::Vector3d axis;
  double lower = 0;  ///< radians, at most 0
  double upper = 0;  ///< radians, at least 0
};

/// A point of a limb's centre line and the limb's radius there.
struct LimbNode {
  Eigen::Vector3d position;
  double radius = 0;
};

/// A joint at a node of a limb: it moves what follows that node.
struct Joint {
  int node = 0;
  std::vector<Hinge> hinges;
};

/// A part of a body: a tube of varying radius about a smooth curve through its nodes, and its joints. A limb without
/// joints is stiff and moves with its parent.
struct Limb {
  std::string kind = {};  ///< what it is; limbs of one kind share their proportions
  std::string side = {};  ///< which of its kind it is; empty where there is only one
  int parent = -1;  ///< index of the limb that it hangs from, by the point closest to its first node; -1: the root
  std::vector<LimbNode> nodes;
  std::vector<Joint> joints = {};
  bool curls = false;  ///< whether neighbouring joints bend alike, as those of a tail or a tentacle do
  double blend = 0.5;  ///< width of the rounding where it meets the body, in radii of its first node
  Eigen::Vector3d flat_axis = Eigen::Vector3d::UnitZ();  ///< direction in which it is flattened
  double flatness = 1;                                   ///< its thickness along flat_axis, in radii; 1: round
};

/// An articulated body in its rest pose: x forward, y to its left, z up; the limbs are the parts. A limb's parent comes
/// before it. Limbs are far enough apart in the rest pose not to blend where they are not joined.
struct Skeleton {
  std::string name;
  std::vector<Limb> limbs;
};

/// "kind" or "kind side": what the part is called.
std::string part_name(const Limb& limb);

/// A hinge about an axis (of any length) from lower <= 0 to upper >= 0 degrees.
Hinge hinge(const Eigen::Vector3d& axis, double lower_degrees, double upper_degrees);

/// A hinge that turns the direction `from` towards the direction `to` for positive angles.
Hinge hinge_towards(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double lower_degrees, double upper_degrees);

/// A hinge about y: the front goes down for positive angles, what hangs down swings back.
Hinge pitch_hinge(double lower_degrees, double upper_degrees);
/// A hinge about z: the front goes to the left for positive angles.
Hinge yaw_hinge(double lower_degrees, double upper_degrees);
/// A hinge about x: the left side goes up for positive angles.
Hinge roll_hinge(double lower_degrees, double upper_degrees);

/// Joints with the same hinges at the nodes first, ..., last.
std::vector<Joint> joints_along(int first, int last, const std::vector<Hinge>& hinges);

/// Adds a limb; returns its index.
int add_limb(Skeleton& skeleton, Limb limb);

/// Adds the limb as the left one and its mirror image in the plane y = 0 as the right one; the mirror image hangs from
/// the same parent, or, where `parent_pair` holds, from the limb after it, which is the parent's own mirror image.
/// Returns the index of the left one.
int add_limb_pair(Skeleton& skeleton, const Limb& limb, bool parent_pair = false);

/// The limb turned about the vertical axis through the origin, with another side's name.
Limb turned(const Limb& limb, double degrees, const std::string& side);

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
