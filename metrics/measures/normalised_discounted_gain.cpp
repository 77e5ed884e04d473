#include "shapegauge/metrics/measures/normalised_discounted_gain.h"

#include <cmath>

#include "shapegauge/metrics/measures/share_of_ideal_gain.h"

namespace shapegauge {
namespace {

double gain_at(std::size_t rank) { return 1.0 / std::log2(static_cast<double>(rank + 1)); }

}  // namespace

double normalised_discounted_gain(const RankedList& list) { return share_of_ideal_gain(list, gain_at); }

}  // namespace shapegauge
