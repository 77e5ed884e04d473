// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace shapegauge {

/// Computes the L1 ("city block") distance, the sum over i of |a[i] - b[i]|, in double precision. Eight partial sums
/// (of the entries i with the same i % 8) are added at the end. The relative error is at most (n / 8 + 5) 2^-53 for n
/// entries of any size and difference. For signatures that sum to 1 it is between 0 and 2, twice the total variation
/// distance. The spans must have equal lengths.
double l1_distance(std::span<const float> a, std::span<const float> b);

/// Computes L1 distances in batches, equal to l1_distance() to the bit, from each signature of `some` to each of
/// `others`. Signatures have `size` entries and are contiguous. Writes one row of `distances` per signature of `some`.
/// Much faster than single distances from a few dozen signatures on.
void l1_distances(std::span<const float> some, std::span<const float> others, std::size_t size,
                  std::span<double> distances);

}  // namespace shapegauge
