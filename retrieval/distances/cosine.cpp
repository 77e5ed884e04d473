#include "shapegauge/retrieval/distances/cosine.h"

#include <cmath>
#include <cstddef>

namespace shapegauge {

namespace {

double length_of(std::span<const float> vector) {
  double sum = 0;
  for (const float entry : vector) sum += static_cast<double>(entry) * static_cast<double>(entry);
  return std::sqrt(sum);
}

}  // namespace

double cosine_distance(std::span<const float> a, std::span<const float> b) {
  const double length_a = length_of(a);
  const double length_b = length_of(b);
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = static_cast<double>(a[i]) / length_a - static_cast<double>(b[i]) / length_b;
    sum += difference * difference;
  }
  return sum / 2;
}

}  // namespace shapegauge
