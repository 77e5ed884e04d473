#pragma once

#include "shapegauge/metrics/measures/measure.h"

namespace shapegauge {

/// R@k; see its definition below.
double recall_at(const RankedList& list, std::size_t k);

inline constexpr MeasureDefinition recall_at_definition{
    .name = "R@k",
    .title = "recall at k",
    .definition =
        "The share of the relevant models that is among the first k ranks: the sum of h(1) to h(k), "
        "divided by R.",
    .source = "trec_eval, NIST's program of the TREC conferences (recall_k).",
    .caveat =
        "A perfect method has k / R at most where k < R. In papers on metric learning R@k often means "
        "something else: whether there is a hit among the first k at all.",
    .value_at = recall_at,
};

}  // namespace shapegauge
