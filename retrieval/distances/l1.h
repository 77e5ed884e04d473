#pragma once

#include <span>

namespace shapegauge {

/// L1 ("city block") distance: sum over i of |a[i] - b[i]|, summed in double precision from the first entry to the
/// last. Between 0 and 2 for signatures that sum to 1, where it is twice the total variation distance. The spans are of
/// equal length.
double l1_distance(std::span<const float> a, std::span<const float> b);

}  // namespace shapegauge
