#pragma once

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// The surface area, or the sum of a point cloud's point_weights(), in the shape's units squared. Throws InputError
/// where it is zero or not finite, or the shape unusable (validity.h).
double positive_area(const Shape& shape);

/// The shape scaled about the origin so that its positive_area(), which it throws as, is 1 (the design, section 3).
Shape scaled_to_unit_area(Shape shape);

}  // namespace shapegauge
