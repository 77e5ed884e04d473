#include "shapegauge/metrics/measures/discounted_cumulative_gain.h"

#include <cmath>

#include "shapegauge/metrics/measures/share_of_ideal_gain.h"

namespace shapegauge {
namespace {

double gain_at(std::size_t rank) { return rank == 1 ? 1.0 : 1.0 / std::log2(static_cast<double>(rank)); }

}  // namespace

double discounted_cumulative_gain(const RankedList& list) { return share_of_ideal_gain(list, gain_at); }

}  // namespace shapegauge
