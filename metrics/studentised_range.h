// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace shapegauge {

/// Computes the probability that the range of `count` independent standard normal values is at most `range`: the
/// distribution of the studentised range with infinitely many degrees of freedom. Tukey, "The problem of multiple
/// comparisons", 1953. Accurate to about 1e-12. Throws ArgumentError for a count below 2 and a range that is NaN.
double studentised_range_probability(double range, std::size_t count);

/// Computes the value that the range of `count` independent standard normal values exceeds with probability `alpha`,
/// the inverse of studentised_range_probability(). Throws ArgumentError for a count below 2 and an alpha that is not
/// between 0 and 1.
double studentised_range_quantile(double alpha, std::size_t count);

}  // namespace shapegauge
