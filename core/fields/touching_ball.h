// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "shapegauge/core/spatial/closest_point.h"

/// Radii of balls that touch a plane at the origin, for a shape of diagonal 1; not part of the public interface.
namespace shapegauge {

/// Returns the unit normal of a triangle by the order of its corners; zero for a degenerate triangle.
Eigen::Vector3d oriented_normal(const Triangle& triangle);

/// Criterion for points opposite to the origin: only these limit the size of a ball (inscribed_ball()).
struct OppositePoints {
  Eigen::Vector3d direction;  ///< unit vector from the origin to the centres of the balls
  double cone_cosine;         ///< cosine of the largest angle between `direction` and the vector to an opposite point
  double min_cosine;  ///< cosine of the largest angle between `direction` and the normal of an opposite triangle
  double rounding;    ///< distance below which a point counts as coincident with the origin
};

/// Returns the radius of the ball through the point q that touches, at the origin, the plane normal to
/// `opposite.direction`, on which its centre lies; infinity if q is not an opposite point (OppositePoints).
double touching_radius(const Eigen::Vector3d& q, const OppositePoints& opposite);

/// Returns the radius of the largest ball that touches the plane at the origin and contains no opposite point of the
/// triangle: the minimum of |q|^2 / (2 q.direction) over these points q. Infinity if there is none, if the cosine
/// between the normal that points away from the origin and the direction is below `min_cosine`, if a corner is at the
/// origin, and for a degenerate triangle. `normal` is oriented_normal() of the triangle. If the radius is not below
/// `limit`, any value of at least `limit` may be returned.
double touching_radius(const Triangle& triangle, const Eigen::Vector3d& normal, const OppositePoints& opposite,
                       double limit);

}  // namespace shapegauge
