#pragma once

#include <cstddef>
#include <span>

namespace shapegauge {

/// L1 ("city block") distance: sum over i of |a[i] - b[i]|, in double precision, as eight sums (of the entries i with
/// the same i % 8) that are added up at the end: off by at most (n / 8 + 5) 2^-53 of itself for n entries, however
/// large they are and however little they differ. Between 0 and 2 for signatures that sum to 1, where it is twice the
/// total variation distance. The spans are of equal length.
double l1_distance(std::span<const float> a, std::span<const float> b);

/// The same distances, bit by bit, from each of some signatures to each of others, all of `size` entries, which follow
/// each other in memory; one row of distances for each of the first. Much faster than one by one, for a few dozen of
/// each.
void l1_distances(std::span<const float> some, std::span<const float> others, std::size_t size,
                  std::span<double> distances);

}  // namespace shapegauge
