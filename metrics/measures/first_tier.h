#pragma once

#include "shapegauge/metrics/measures/measure.h"

namespace shapegauge {

/// FT; see its definition below.
double first_tier(const RankedList& list);

inline constexpr MeasureDefinition first_tier_definition{
    .name = "FT",
    .title = "first tier",
    .definition = "The recall among the first R ranks: the sum of h(1) to h(R), divided by R.",
    .source = "Shilane, Min, Kazhdan, Funkhouser, The Princeton Shape Benchmark, SMI 2004, section 4.",
    .caveat =
        "Under psb R is C - 1 for a class of C models. Under paper R is C and the query itself is the "
        "first hit, which makes the figure larger: psb = (C paper - 1) / (C - 1). Under psb and trec the "
        "same as R-prec.",
    .value = first_tier,
};

}  // namespace shapegauge
