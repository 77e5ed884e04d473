#include "shapegauge/retrieval/distances/l1.h"

#include <cmath>
#include <cstddef>

namespace shapegauge {

double l1_distance(std::span<const float> a, std::span<const float> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i]));
  return sum;
}

}  // namespace shapegauge
