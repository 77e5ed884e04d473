#include "shapegauge/metrics/measures/discounted_cumulative_gain.h"

#include <cmath>

namespace shapegauge {
namespace {

double gain_at(std::size_t rank) { return rank == 1 ? 1.0 : 1.0 / std::log2(static_cast<double>(rank)); }

}  // namespace

double discounted_cumulative_gain(const RankedList& list) {
  double ideal = 0;
  // Both sums grow in the same order, so that a perfect list gives exactly 1.
  for (std::size_t rank = 1; rank <= list.relevant; ++rank) ideal += gain_at(rank);
  return gain_of_hits(list, gain_at) / ideal;
}

}  // namespace shapegauge
