#include "shapegauge/metrics/measures/e_measure.h"

#include <algorithm>

namespace shapegauge {
namespace {

constexpr std::size_t first_page = 32;  // results that a user is taken to look at

}  // namespace

double e_measure(const RankedList& list) {
  const std::size_t looked_at = std::min(first_page, list.length);
  return 2 * hits_among_first(list, looked_at) / static_cast<double>(looked_at + list.relevant);
}

}  // namespace shapegauge
