#include "shapegauge/metrics/measures/discounted_cumulative_gain.h"

#include <cmath>

namespace shapegauge {
namespace {

double gain_at(std::size_t rank) { return rank == 1 ? 1.0 : 1.0 / std::log2(static_cast<double>(rank)); }

}  // namespace

double discounted_cumulative_gain(const RankedList& list) {
  double gained = 0;
  double ideal = 0;
  std::size_t hits = 0;
  // Both sums grow in the same order, so that a perfect list gives exactly 1.
  for (const std::size_t rank : ranks_of_hits(list)) {
    gained += gain_at(rank);
    ideal += gain_at(++hits);
  }
  return gained / ideal;
}

}  // namespace shapegauge
