// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Computes one Morton code per point: the index (below 2^63) of its cell along a Morton curve through the bounding
/// box.
std::vector<std::uint64_t> morton_codes(const Points& points);

/// Sorts points along a Morton curve through their bounding box and returns their indices. Neighbours in the order are
/// close in space. Points in the same cell (morton_codes()) keep their order.
std::vector<std::int32_t> morton_order(const Points& points);

}  // namespace shapegauge
