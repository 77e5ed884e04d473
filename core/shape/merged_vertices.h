#pragma once

#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// For each vertex the index of the first vertex at exactly the same place: its own, unless an earlier one is there.
std::vector<std::int32_t> merged_by_place(const Points& vertices);

}  // namespace shapegauge
