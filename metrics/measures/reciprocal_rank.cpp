#include "shapegauge/metrics/measures/reciprocal_rank.h"

namespace shapegauge {

double reciprocal_rank(const RankedList& list) { return list.precision_at_hit.front(); }

}  // namespace shapegauge
