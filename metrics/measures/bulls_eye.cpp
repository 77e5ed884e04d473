#include "shapegauge/metrics/measures/bulls_eye.h"

namespace shapegauge {

double bulls_eye(const RankedList& list) {
  if (list.starts_with_query) return hits_among_first(list, 2 * list.relevant) / static_cast<double>(list.relevant);
  const std::size_t class_size = list.relevant + 1;
  return (1 + hits_among_first(list, 2 * class_size - 1)) / static_cast<double>(class_size);
}

}  // namespace shapegauge
