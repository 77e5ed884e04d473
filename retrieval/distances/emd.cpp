#include "shapegauge/retrieval/distances/emd.h"

#include <cmath>
#include <cstddef>

#include "shapegauge/retrieval/distances/histogram_sum.h"

namespace shapegauge {

double earth_movers_distance(std::span<const float> a, std::span<const float> b) {
  const double sum_a = histogram_sum(a);
  const double sum_b = histogram_sum(b);
  double to_move = 0;
  double work = 0;
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    to_move += static_cast<double>(a[i]) / sum_a - static_cast<double>(b[i]) / sum_b;
    work += std::abs(to_move);
  }
  return work;
}

}  // namespace shapegauge
