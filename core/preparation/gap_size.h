#pragma once

#include <limits>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// The radius of the gaps through which an offset surface leaks into a shape, in the shape's units; an r above it
/// closes them.
///
/// Of a mesh: the radius of the largest circle that fits into a hole, each hole being a boundary loop seen along its
/// vector area; holes wider than the limit do not count, so that the mouth of a vase need not pass for a gap. 0 for a
/// closed mesh. Of a cloud, whatever the limit: the distance within which 999 of 1000 points have their sixth
/// neighbour, or the last one where there are fewer; of points placed at random, the balls of that radius leave hardly
/// a hole. Holes in a scan are not seen. Throws InputError where the shape is unusable (validity.h).
double gap_size(const Shape& shape, double limit = std::numeric_limits<double>::infinity());

/// How far apart the points of a cloud are: the median distance to the sixth neighbour, on a regular surface about 1.4
/// times the mean distance. 0 for a mesh. Throws InputError where the shape is unusable (validity.h).
double point_spacing(const Shape& shape);

}  // namespace shapegauge
