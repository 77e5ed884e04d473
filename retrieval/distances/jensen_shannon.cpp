#include "shapegauge/retrieval/distances/jensen_shannon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "shapegauge/retrieval/distances/histogram_sum.h"

namespace shapegauge {

namespace {

double divergence(double p, double mean) { return p > 0 ? p * std::log2(p / mean) : 0.0; }

}  // namespace

double jensen_shannon_distance(std::span<const float> a, std::span<const float> b) {
  const double sum_a = histogram_sum(a);
  const double sum_b = histogram_sum(b);
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double p = static_cast<double>(a[i]) / sum_a;
    const double q = static_cast<double>(b[i]) / sum_b;
    const double mean = (p + q) / 2;
    sum += divergence(p, mean) + divergence(q, mean);
  }
  return std::sqrt(std::max(0.0, sum / 2));  // rounding may leave a little less than nothing
}

}  // namespace shapegauge
