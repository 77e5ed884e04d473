#include "shapegauge/metrics/measures/share_of_ideal_gain.h"

namespace shapegauge {

double share_of_ideal_gain(const RankedList& list, double (*gain)(std::size_t rank)) {
  double ideal = 0;
  // Both sums grow in the same order, so that a perfect list gives exactly 1.
  for (std::size_t rank = 1; rank <= list.relevant; ++rank) ideal += gain(rank);
  return gain_of_hits(list, gain) / ideal;
}

}  // namespace shapegauge
