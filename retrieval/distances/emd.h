#pragma once

#include <span>

namespace shapegauge {

/// Earth mover's distance of two histograms over a line, each first divided by its sum: the sum of the magnitudes of
/// the differences of their cumulative sums, that is, the least work of moving one into the other, in bins. Entries may
/// not be negative nor all be 0. Rubner, Tomasi, Guibas, "The earth mover's distance as a metric for image retrieval",
/// IJCV 40, 2000. The order of the entries matters: it suits one histogram, not a concatenation of several. The spans
/// are of equal length.
double earth_movers_distance(std::span<const float> a, std::span<const float> b);

}  // namespace shapegauge
