#pragma once

#include <cstddef>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Counts the inner surfaces of a hollow body: closed components with the opposite orientation to the largest one,
/// inside the box of a larger component that is oriented like it. Returns 0 for a cloud, and for a mesh that is not
/// closed and consistently oriented. Throws InputError for an unusable shape (require_usable()).
std::size_t cavity_count(const Shape& shape);

}  // namespace shapegauge
