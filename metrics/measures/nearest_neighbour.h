#pragma once

#include "shapegauge/metrics/measures/measure.h"

namespace shapegauge {

/// NN; see its definition below.
double nearest_neighbour(const RankedList& list);

inline constexpr MeasureDefinition nearest_neighbour_definition{
    .name = "NN",
    .title = "nearest neighbour",
    .definition = "1 where the nearest model other than the query is relevant, else 0: h(1).",
    .source = "Shilane, Min, Kazhdan, Funkhouser, The Princeton Shape Benchmark, SMI 2004, section 4.",
    .caveat =
        "One model decides, so an exact duplicate of the query in the data set makes it 1. The mean over "
        "queries is the accuracy of a nearest-neighbour classifier.",
    .value = nearest_neighbour,
};

}  // namespace shapegauge
