#pragma once

#include <cstddef>

#include "shapegauge/metrics/ranked_list.h"

namespace shapegauge {

/// Mean of the sum of gain(rank) over all hits, divided by that of the ideal list, which begins with all relevant
/// models. Ranks count from 1.
double share_of_ideal_gain(const RankedList& list, double (*gain)(std::size_t rank));

}  // namespace shapegauge
