#pragma once

#include <span>

namespace shapegauge {

/// 1 - the cosine of the angle between two vectors, from 0 (same direction) to 2. Computed as half of the squared
/// distance of the unit vectors, which is the same and has no cancellation for nearly parallel ones. Neither vector may
/// be zero. The spans are of equal length.
double cosine_distance(std::span<const float> a, std::span<const float> b);

}  // namespace shapegauge
