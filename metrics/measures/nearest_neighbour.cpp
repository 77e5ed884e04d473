#include "shapegauge/metrics/measures/nearest_neighbour.h"

namespace shapegauge {

double nearest_neighbour(const RankedList& list) {
  return list.starts_with_query ? hits_among_first(list, 2) - 1 : hits_among_first(list, 1);
}

}  // namespace shapegauge
