#pragma once

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// How the area of a damaged shape is estimated.
struct TubeAreaOptions {
  double radius = 0.02;  ///< of the tube, as a fraction of the bounding-box diagonal; greater than 0
};

/// The area of a surface from the volume of the tube around it, all points within a radius r: V / 2r, in the shape's
/// units squared.
///
/// By Weyl's formula the volume of the tube about a closed surface is 2 r A + (4/3) pi r^3 per component, whatever its
/// curvature, as long as r is less than the radius of curvature and half of the thickness. The tube closes cracks
/// narrower than 2r, levels noise smaller than r, and exists for point clouds, too; so V / 2r stays where the sum of
/// the triangles' areas does not. Of a cloud of n points placed at random, the tube fills a share of 1 - D(s) / s, s^2
/// = n pi r^2 / A, D Dawson's integral; the estimate allows for that.
///
/// Throws InputError where the shape has no extent or the radius is out of range.
double tube_area(const Shape& shape, const TubeAreaOptions& options = {});

}  // namespace shapegauge
