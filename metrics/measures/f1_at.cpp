#include "shapegauge/metrics/measures/f1_at.h"

namespace shapegauge {

double f1_at(const RankedList& list, std::size_t k) {
  return 2 * hits_among_first(list, k) / static_cast<double>(k + list.relevant);
}

}  // namespace shapegauge
