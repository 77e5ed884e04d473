#pragma once

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// The radius of the gaps through which an offset surface leaks into a shape, in the shape's units; an r above it
/// closes them.
///
/// Of a mesh: the least radius (BoundaryLoop) up to which 99 % of the length of all boundary lies. 0 for a closed mesh;
/// of an open surface, the mouth of a vase, the opening counts as well. Of a cloud: the distance within which 999 of
/// 1000 points have their sixth neighbour, or the last one where there are fewer; of points placed at random, the balls
/// of that radius leave hardly a hole. Holes in a scan are not seen. Throws InputError where the shape is unusable
/// (validity.h).
double gap_size(const Shape& shape);

/// How far apart the points of a cloud are: the median distance to the sixth neighbour, on a regular surface about 1.4
/// times the mean distance. 0 for a mesh. Throws InputError where the shape is unusable (validity.h).
double point_spacing(const Shape& shape);

}  // namespace shapegauge
