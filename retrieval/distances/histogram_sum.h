#pragma once

#include <span>

namespace shapegauge {

/// The sum of the entries, in double precision from the first to the last.
inline double histogram_sum(std::span<const float> histogram) {
  double sum = 0;
  for (const float entry : histogram) sum += static_cast<double>(entry);
  return sum;
}

}  // namespace shapegauge
