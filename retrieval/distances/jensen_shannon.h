#pragma once

#include <span>

namespace shapegauge {

/// Jensen-Shannon distance of two histograms, each first divided by its sum: the square root of the mean of the
/// Kullback-Leibler divergences from each to the mean of both, in bits; a metric, between 0 and 1. Entries may not be
/// negative nor all be 0. Endres and Schindelin, "A new metric for probability distributions", IEEE Transactions on
/// Information Theory 49, 2003. The spans are of equal length.
double jensen_shannon_distance(std::span<const float> a, std::span<const float> b);

}  // namespace shapegauge
