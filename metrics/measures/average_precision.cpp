#include "shapegauge/metrics/measures/average_precision.h"

namespace shapegauge {

double average_precision(const RankedList& list) {
  double sum = 0;
  for (const double precision : list.precision_at_hit) sum += precision;
  return sum / static_cast<double>(list.relevant);
}

}  // namespace shapegauge
