#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>
#include <string>
#include <vector>

#include "shapegauge/datasets/generator/skeleton.h"

namespace shapegauge {

/// A body as the set where a function is negative. Near the surface the function is close to the distance.
struct Solid {
  std::function<double(const Eigen::Vector3d&)> distance;
  Eigen::AlignedBox3d box;  ///< holds the body
};

/// A point (distance from the axis, height) of the outline of a body of revolution.
using Outline = std::vector<Eigen::Vector2d>;

/// A box with rounded edges. The rounding is part of the half sizes.
Solid rounded_box(const Eigen::Vector3d& centre, const Eigen::Vector3d& half_sizes, double rounding);

/// The body between an outline and the z axis, which the outline's ends are joined to, rounded outwards.
Solid revolved(const Outline& outline, double rounding);

/// The wall about an outline, turned about the z axis: a vessel.
Solid revolved_wall(const Outline& outline, double thickness);

/// A cylinder with rounded edges about the segment from one point to another. The rounding is part of its size.
Solid rounded_cylinder(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius, double rounding);

/// A tube of varying radius along a smooth curve, flattened as a limb is.
Solid tube(const std::vector<LimbNode>& nodes, const Eigen::Vector3d& flat_axis = Eigen::Vector3d::UnitZ(),
           double flatness = 1);

/// What is in both. `within` may be a body without bounds.
Solid intersection(const Solid& solid, const Solid& within);

/// What is in the first and not in the second.
Solid difference(const Solid& solid, const Solid& removed);

/// All points between two heights.
Solid slab(double low, double high);

/// The body moved.
Solid transformed_solid(const Solid& solid, const Eigen::Isometry3d& motion);

/// The body turned about the z axis.
Solid turned_about_z(const Solid& solid, double degrees);

/// One part of an object.
struct SolidPart {
  int label = 0;  ///< which of its class's parts it is
  Solid solid;
};

/// A rigid object made of parts, which are united; the creases between them are rounded off.
struct SolidObject {
  std::vector<SolidPart> parts;
  double blend = 0.02;     ///< width of the rounding
  double thinnest = 0.05;  ///< thickness of its thinnest wall

  /// Value of the whole object's function: negative inside.
  [[nodiscard]] double distance(const Eigen::Vector3d& point) const;

  /// The label of the part with the least distance, of equal ones the first.
  [[nodiscard]] int label_at(const Eigen::Vector3d& point) const;
};

}  // namespace shapegauge
