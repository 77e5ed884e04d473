// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

/// Medians and quantiles of one or more numbers.
namespace shapegauge {

/// Returns the median of at least one sorted number; for an even count, the mean of the two middle ones.
inline double sorted_median(std::span<const double> sorted) {
  const std::size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
}

/// Returns the median of at least one number; for an even count, the greater of the two middle values. Reorders the
/// values.
inline double upper_median(std::span<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Returns the quantile of at least one value at a fraction in [0, 1]: the value at index floor(fraction (n - 1)) of
/// the n sorted values. Reorders the values.
inline double lower_quantile(std::span<double> values, double fraction) {
  const auto rank = values.begin() + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), rank, values.end());
  return *rank;
}

}  // namespace shapegauge
