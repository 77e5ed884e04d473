#pragma once

#include <Eigen/Core>

#include "shapegauge/core/spatial/closest_point.h"

namespace shapegauge {

/// Where a ray leaves a rounded triangle: all points within the radius of the triangle, a convex body made of three
/// balls, three cylinders and a prism (docs/reference/definitions.md#offset-sdf). Returns the ray's parameter at the
/// last point inside, or a negative number where the ray misses the body or has left it before its origin. The
/// direction has length 1.
double exit_from_rounded_triangle(const Triangle& triangle, double radius, const Eigen::Vector3d& origin,
                                  const Eigen::Vector3d& direction);

}  // namespace shapegauge
