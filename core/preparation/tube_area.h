// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Estimates the area of a surface, in the shape's units squared, as V / 2r, where V is the volume of the tube around
/// it: all points within a distance r of the surface. The argument `r` is a fraction of the bounding-box diagonal.
///
/// By Weyl's formula the volume of the tube about a smooth closed surface is 2 r A + (4/3) pi r^3 X, with its Euler
/// characteristic X (2 for a sphere, 0 for a torus). This holds for any curvature if r is less than the radius of
/// curvature and half of the thickness. Sharp edges reduce it slightly (a cube: 1 % at r = 0.02). The tube closes
/// cracks narrower than 2r, smooths noise smaller than r, and is defined for point clouds. V / 2r is therefore stable
/// where the sum of the triangles' areas is not. The tube of a cloud with n random points fills a fraction of 1 - D(s)
/// / s, with s^2 = n pi r^2 / A and Dawson's integral D. The estimate corrects for that, down to a fraction of a half.
///
/// V is summed over cubes of edge r/2 or 1/256 of the diagonal, whichever is larger.
///
/// Throws InputError for an unusable shape (require_usable()), one without extent, and a radius out of bounds.
double tube_area(const Shape& shape, double r = 0.02);

}  // namespace shapegauge
