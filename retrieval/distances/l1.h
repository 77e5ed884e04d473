#pragma once

#include <span>

namespace shapegauge {

/// L1 ("city block") distance: sum over i of |a[i] - b[i]|, in double precision, as eight sums (of the entries i with
/// the same i % 8) that are added up at the end. Between 0 and 2 for signatures that sum to 1, where it is twice the
/// total variation distance. The spans are of equal length.
double l1_distance(std::span<const float> a, std::span<const float> b);

/// The same distances, bit by bit, from one signature to several of its length that follow each other in memory, as
/// many as there is room for distances: faster than one by one.
void l1_distances(std::span<const float> a, std::span<const float> others, std::span<double> distances);

}  // namespace shapegauge
