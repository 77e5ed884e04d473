#include "shapegauge/metrics/measures/tier.h"

namespace shapegauge {
namespace {

double recall_among_first(const RankedList& list, std::size_t count) {
  return static_cast<double>(hits_among_first(list, count)) / static_cast<double>(list.relevant);
}

}  // namespace

double first_tier(const RankedList& list) { return recall_among_first(list, list.relevant); }

double second_tier(const RankedList& list) { return recall_among_first(list, 2 * list.relevant); }

}  // namespace shapegauge
