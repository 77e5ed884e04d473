#pragma once

#include <span>

namespace shapegauge {

/// L2 (Euclidean) distance: the square root of the sum of (a[i] - b[i])^2, in double precision. The spans are of equal
/// length.
double l2_distance(std::span<const float> a, std::span<const float> b);

}  // namespace shapegauge
