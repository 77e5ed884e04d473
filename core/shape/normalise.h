#pragma once

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// The shape scaled about the origin so that its surface area, or the sum of a point cloud's point_weights(), is 1 (the
/// design, section 3). Throws InputError where that area is zero or not finite, or the shape unusable (validity.h).
Shape scaled_to_unit_area(Shape shape);

}  // namespace shapegauge
