#pragma once

#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// The place of each point along a Morton curve through the points' bounding box: the number of its cell of 2^63.
std::vector<std::uint64_t> morton_codes(const Points& points);

/// The points' indices in the order of a Morton curve through their bounding box, so that neighbours in the order are
/// near each other in space. Points in the same of the curve's 2^63 cells keep their order.
std::vector<std::int32_t> morton_order(const Points& points);

}  // namespace shapegauge
