#include "shapegauge/metrics/measures/second_tier.h"

namespace shapegauge {

double second_tier(const RankedList& list) {
  return hits_among_first(list, 2 * list.relevant) / static_cast<double>(list.relevant);
}

}  // namespace shapegauge
