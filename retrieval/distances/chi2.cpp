#include "shapegauge/retrieval/distances/chi2.h"

#include <cmath>
#include <cstddef>

namespace shapegauge {

double chi2_distance(std::span<const float> a, std::span<const float> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double total = static_cast<double>(a[i]) + static_cast<double>(b[i]);
    const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    if (total > 0) sum += difference * difference / total;
  }
  return sum / 2;
}

}  // namespace shapegauge
