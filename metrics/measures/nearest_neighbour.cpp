#include "shapegauge/metrics/measures/nearest_neighbour.h"

namespace shapegauge {

double nearest_neighbour(const RankedList& list) { return list.hits.at(list.starts_with_query ? 1 : 0) ? 1.0 : 0.0; }

}  // namespace shapegauge
