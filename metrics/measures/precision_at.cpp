#include "shapegauge/metrics/measures/precision_at.h"

namespace shapegauge {

double precision_at(const RankedList& list, std::size_t k) {
  return hits_among_first(list, k) / static_cast<double>(k);
}

}  // namespace shapegauge
