#pragma once

#include "shapegauge/metrics/measures/measure.h"

namespace shapegauge {

/// P@k; see its definition below.
double precision_at(const RankedList& list, std::size_t k);

inline constexpr MeasureDefinition precision_at_definition{
    .name = "P@k",
    .title = "precision at k",
    .definition = "The share of hits among the first k ranks: the sum of h(1) to h(k), divided by k.",
    .source = "trec_eval, NIST's program of the TREC conferences (P_k).",
    .caveat =
        "Divided by k even where the list is shorter or R < k, so that a perfect method has R / k at "
        "most.",
    .value_at = precision_at,
};

}  // namespace shapegauge
