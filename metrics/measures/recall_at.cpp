#include "shapegauge/metrics/measures/recall_at.h"

namespace shapegauge {

double recall_at(const RankedList& list, std::size_t k) {
  return hits_among_first(list, k) / static_cast<double>(list.relevant);
}

}  // namespace shapegauge
