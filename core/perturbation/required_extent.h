#pragma once

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// The diagonal of the bounding box. Throws InputError where it is zero or not a normal number: there is no length then
/// to take a fraction of.
double required_diagonal(const Shape& shape);

}  // namespace shapegauge
