// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <functional>
#include <vector>

#include "shapegauge/datasets/generator/skeleton.h"

namespace shapegauge {

/// Solid as the set where a function is negative. Near the surface the function approximates the distance.
struct Solid {
  std::function<double(const Eigen::Vector3d&)> distance;  ///< implicit function of a point, negative inside
  Eigen::AlignedBox3d box;                                 ///< bounding box of the solid; empty if unbounded
};

/// Outline of a solid of revolution: points (distance from the axis, height).
using Outline = std::vector<Eigen::Vector2d>;

/// Makes a box with rounded edges. `half_sizes` include the radius `rounding`.
Solid rounded_box(const Eigen::Vector3d& centre, const Eigen::Vector3d& half_sizes, double rounding);

/// Makes the solid of revolution between an outline and the z axis, with its ends joined to the axis. The solid grows
/// by the radius `rounding`, which rounds its edges.
Solid revolved(const Outline& outline, double rounding);

/// Makes a vessel: a wall of constant thickness along an outline, rotated about the z axis.
Solid revolved_wall(const Outline& outline, double thickness);

/// Makes a cylinder with rounded edges about a segment. `radius` and the length include the rounding.
Solid rounded_cylinder(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius, double rounding);

/// Makes a tube of varying radius along a smooth curve through the nodes. `flatness` is the thickness along `flat_axis`
/// relative to the width.
Solid tube(const std::vector<LimbNode>& nodes, const Eigen::Vector3d& flat_axis = Eigen::Vector3d::UnitZ(),
           double flatness = 1);

/// Intersects two solids; keeps the bounding box of the first. `within` may be unbounded.
Solid intersection(const Solid& solid, const Solid& within);

/// Subtracts the solid `removed` from the first; keeps the bounding box of the first.
Solid difference(const Solid& solid, const Solid& removed);

/// Makes the unbounded set of all points with z between `low` and `high`, for intersections.
Solid slab(double low, double high);

/// Applies a rigid motion to a bounded solid.
Solid transformed_solid(const Solid& solid, const Eigen::Isometry3d& motion);

/// Rotates a bounded solid about the z axis.
Solid rotated_about_z(const Solid& solid, double degrees);

/// Labelled part of a rigid object.
struct SolidPart {
  int label = 0;  ///< index of the part in ObjectClass::parts
  Solid solid;    ///< geometry of the part
};

/// Rigid object: the union of its parts, with rounded creases between them.
struct SolidObject {
  std::vector<SolidPart> parts;  ///< labelled parts, which may overlap
  double blend = 0.02;           ///< width of the smooth blend between parts, in coordinate units
  double thinnest = 0.05;        ///< thickness of the thinnest wall, in coordinate units, for the choice of the grid

  /// Evaluates the implicit function of the whole object: approximately the signed distance, negative inside.
  [[nodiscard]] double distance(const Eigen::Vector3d& point) const;

  /// Returns the label of the part with the minimum distance (ties: the first).
  [[nodiscard]] int label_at(const Eigen::Vector3d& point) const;
};

}  // namespace shapegauge
