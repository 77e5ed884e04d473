#include "shapegauge/metrics/measures/area_under_curve.h"

namespace shapegauge {

double area_under_curve(const RankedList& list) {
  double before = list.precision_at_hit.front();
  double sum = 0;
  for (const double precision : list.precision_at_hit) {
    sum += (before + precision) / 2;
    before = precision;
  }
  return sum / static_cast<double>(list.relevant);
}

}  // namespace shapegauge
