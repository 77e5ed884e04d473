#pragma once

#include "shapegauge/metrics/measures/first_tier.h"

namespace shapegauge {

inline constexpr MeasureDefinition r_precision_definition{
    .name = "R-prec",
    .title = "R-precision",
    .definition = "The precision at rank R: the sum of h(1) to h(R), divided by R.",
    .source = "trec_eval, NIST's program of the TREC conferences (Rprec).",
    .caveat =
        "The first tier (FT) under the name of text retrieval; where a list ends before rank R the "
        "missing ranks count as misses.",
    .value = first_tier,
};

}  // namespace shapegauge
