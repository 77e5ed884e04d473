#pragma once

#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// How the area of a damaged shape is estimated.
struct TubeAreaOptions {
  static constexpr Bounds radius_bounds{.low = 0, .high = 1, .low_open = true};

  double radius = 0.02;  ///< of the tube, as a fraction of the bounding-box diagonal
};

/// The area of a surface from the volume of the tube around it, all points within a radius r: V / 2r, in the shape's
/// units squared.
///
/// By Weyl's formula the volume of the tube about a smooth closed surface is 2 r A + (4/3) pi r^3 X, X its Euler
/// characteristic (2 for a sphere, 0 for a torus), whatever its curvature, as long as r is less than the radius of
/// curvature and half of the thickness; sharp edges take a little off (a cube: 1 % at r = 0.02). The tube closes cracks
/// narrower than 2r, levels noise smaller than r, and exists for point clouds, too; so V / 2r is stable where the sum
/// of the triangles' areas is not. Of a cloud with points at n random places, the tube fills a fraction of 1 - D(s) /
/// s, s^2 = n pi r^2 / A, D Dawson's integral; the estimate allows for that, down to a fraction of a half.
///
/// V is summed over cubes of r/2 or 1/256 of the diagonal, whichever is larger.
///
/// Throws InputError for an unusable shape (require_usable()), one without extent, and a radius out of bounds.
double tube_area(const Shape& shape, const TubeAreaOptions& options = {});

}  // namespace shapegauge
