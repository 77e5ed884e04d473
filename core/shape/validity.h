#pragma once

#include <optional>
#include <string>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// What makes a shape unusable: a coordinate that is not a finite number, or a triangle with a vertex that there is
/// not. Nothing where it is usable, as every shape from a reader is.
std::optional<std::string> defect_of(const Shape& shape);

/// Throws InputError "the shape is unusable: ..." where a shape has a defect.
void require_usable(const Shape& shape);

}  // namespace shapegauge
