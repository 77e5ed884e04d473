#include "shapegauge/retrieval/distances/l2.h"

#include <cmath>
#include <cstddef>

namespace shapegauge {

double l2_distance(std::span<const float> a, std::span<const float> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    sum += difference * difference;
  }
  return std::sqrt(sum);
}

}  // namespace shapegauge
