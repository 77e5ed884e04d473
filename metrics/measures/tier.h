#pragma once

#include "shapegauge/metrics/ranked_list.h"

namespace shapegauge {

/// FT, first tier: the recall among the first R ranks, where R is the number of relevant models: hits there / R.
///
/// Source: Shilane et al., "The Princeton Shape Benchmark", SMI 2004, section 4. Elsewhere called R-precision.
/// Caveat: under psb R = C - 1 for a class of C models. Under paper R = C and the query itself is the first hit, which
/// makes the figure larger: psb = (C * paper - 1) / (C - 1).
double first_tier(const RankedList& list);

/// ST, second tier: the recall among the first 2R ranks, or in the whole list where that is shorter: hits there / R.
///
/// Source: as first_tier. Caveat: for a class of more than half of all models it is always 1. The "bull's eye score" is
/// a relative of it, not the same.
double second_tier(const RankedList& list);

}  // namespace shapegauge
