#pragma once

#include <Eigen/Core>
#include <array>

#include "shapegauge/core/spatial/closest_point.h"

/// Balls that touch a plane at the origin, for a shape of diagonal 1; not part of the public interface.
namespace shapegauge {

/// Returns the unit normal by the order of the corners; zero for a degenerate triangle.
Eigen::Vector3d oriented_normal(const Triangle& triangle);

/// Triangle relative to an origin, with its plane.
struct FacingTriangle {
  std::array<Eigen::Vector3d, 3> corners;
  Eigen::Vector3d normal;  ///< by the order of the corners; zero where it has no area
  double distance;         ///< of the plane, along the normal
  double rounding;         ///< distance below which points coincide with the origin

  /// `unit_normal` is oriented_normal() of the triangle, `tolerance` is `rounding`.
  FacingTriangle(const Triangle& triangle, const Eigen::Vector3d& origin, const Eigen::Vector3d& unit_normal,
                 double tolerance)
      : corners{triangle.a - origin, triangle.b - origin, triangle.c - origin},
        normal(unit_normal),
        distance(unit_normal.dot(corners[0])),
        rounding(tolerance) {}

  /// Returns the normal that points away from the origin.
  [[nodiscard]] Eigen::Vector3d away() const { return distance < 0 ? Eigen::Vector3d(-normal) : normal; }

  [[nodiscard]] bool has_corner_at_origin() const;

  /// Returns true if a point of the plane is inside the triangle.
  [[nodiscard]] bool contains(const Eigen::Vector3d& q) const;
};

/// Returns the radius of the ball through q that touches the plane at the origin on the side of its unit normal;
/// infinity if q is not above the plane or closer to the origin than `rounding`.
double touching_radius(const Eigen::Vector3d& q, const Eigen::Vector3d& normal, double rounding);

/// Returns the radius of the largest ball that touches the plane at the origin, lies on the side of its unit normal and
/// does not intersect the interior of the triangle: the minimum of |q|^2 / (2 q.normal) over the triangle's points q
/// above the plane. Infinity if there is no such point, and for a triangle with a corner at the origin. Degenerate
/// triangles are handled as segments or points. A value that is not below the limit may be any such value.
double touching_radius(const FacingTriangle& triangle, const Eigen::Vector3d& normal, double limit);

}  // namespace shapegauge
