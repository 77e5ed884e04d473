#include "shapegauge/metrics/statistics/holm.h"

#include <algorithm>
#include <numeric>

namespace shapegauge {

std::vector<double> holm_adjusted(std::span<const double> p_values) {
  std::vector<std::size_t> ascending(p_values.size());
  std::iota(ascending.begin(), ascending.end(), std::size_t{0});
  std::ranges::stable_sort(ascending, {}, [&](std::size_t i) { return p_values[i]; });
  std::vector<double> adjusted(p_values.size());
  double largest = 0;
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    const auto tests_left = static_cast<double>(ascending.size() - i);
    largest = std::max(largest, std::min(1.0, tests_left * p_values[ascending[i]]));
    adjusted[ascending[i]] = largest;
  }
  return adjusted;
}

}  // namespace shapegauge
