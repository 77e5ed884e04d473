#pragma once

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// The radius of the gaps through which an offset surface leaks into a shape, in the shape's units; an r above it
/// closes them.
///
/// Of a mesh: the radius (BoundaryLoop) below which 99 % of the length of all boundary lies, so that one wide opening,
/// the mouth of a vase, does not pass for a gap unless it is most of the boundary. 0 for a closed mesh. Of a cloud: the
/// distance within which 999 of 1000 points have their sixth neighbour; of points placed at random, the discs of that
/// radius leave hardly a hole. Holes in a scan are not seen.
double gap_size(const Shape& shape);

}  // namespace shapegauge
