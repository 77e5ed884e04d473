#pragma once

#include <cstddef>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Number of the inner surfaces of a hollow body: closed components that are oriented against the largest component and
/// lie within the box of a larger one that is oriented with it. 0 for a mesh that is not watertight and consistently
/// oriented, whose inside is not known, and for a cloud. Throws InputError for an unusable shape (require_usable()).
std::size_t cavity_count(const Shape& shape);

}  // namespace shapegauge
