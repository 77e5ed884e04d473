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
/// neighbour; of points placed at random, discs of that radius leave hardly a hole. Holes in a scan are not seen.
double gap_size(const Shape& shape, double limit = std::numeric_limits<double>::infinity());

}  // namespace shapegauge
