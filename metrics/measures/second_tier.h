#pragma once

#include "shapegauge/metrics/measures/measure.h"

namespace shapegauge {

/// ST; see its definition below.
double second_tier(const RankedList& list);

inline constexpr MeasureDefinition second_tier_definition{
    .name = "ST",
    .title = "second tier",
    .definition = "The recall among the first 2R ranks, or in the whole list where that is shorter.",
    .source = "Shilane, Min, Kazhdan, Funkhouser, The Princeton Shape Benchmark, SMI 2004, section 4.",
    .caveat =
        "For a class of more than half of all models it is always 1. Not the bull's eye score, which "
        "counts the query.",
    .value = second_tier,
};

}  // namespace shapegauge
