#include "shapegauge/metrics/measures/first_tier.h"

namespace shapegauge {

double first_tier(const RankedList& list) {
  return hits_among_first(list, list.relevant) / static_cast<double>(list.relevant);
}

}  // namespace shapegauge
