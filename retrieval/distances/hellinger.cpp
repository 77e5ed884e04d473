#include "shapegauge/retrieval/distances/hellinger.h"

#include <cmath>
#include <cstddef>

#include "shapegauge/retrieval/distances/histogram_sum.h"

namespace shapegauge {

double hellinger_distance(std::span<const float> a, std::span<const float> b) {
  const double sum_a = histogram_sum(a);
  const double sum_b = histogram_sum(b);
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference =
        std::sqrt(static_cast<double>(a[i]) / sum_a) - std::sqrt(static_cast<double>(b[i]) / sum_b);
    sum += difference * difference;
  }
  return std::sqrt(sum / 2);
}

}  // namespace shapegauge
