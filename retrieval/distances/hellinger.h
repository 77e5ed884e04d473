#pragma once

#include <span>

namespace shapegauge {

/// Hellinger distance of two histograms, each first divided by its sum: the L2 distance of the square roots of their
/// entries, divided by the square root of 2; between 0 and 1. Entries may not be negative nor all be 0. The spans are
/// of equal length.
double hellinger_distance(std::span<const float> a, std::span<const float> b);

}  // namespace shapegauge
