#include "shapegauge/metrics/measures/average_precision.h"

namespace shapegauge {

double average_precision(const RankedList& list) {
  double sum = 0;
  std::size_t hits = 0;
  for (const std::size_t rank : ranks_of_hits(list)) sum += static_cast<double>(++hits) / static_cast<double>(rank);
  return sum / static_cast<double>(list.relevant);
}

}  // namespace shapegauge
