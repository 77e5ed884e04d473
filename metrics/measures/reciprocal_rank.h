#pragma once

#include "shapegauge/metrics/measures/measure.h"

namespace shapegauge {

/// MRR; see its definition below.
double reciprocal_rank(const RankedList& list);

inline constexpr MeasureDefinition reciprocal_rank_definition{
    .name = "MRR",
    .title = "mean reciprocal rank",
    .definition = "Of one query: 1 / rank of the first hit, 0 where there is none.",
    .source =
        "Voorhees, The TREC-8 question answering track report, 1999; trec_eval, NIST's program of the "
        "TREC conferences (recip_rank).",
    .caveat =
        "Looks at one hit only. Under paper the query is that hit and the figure is always 1: use psb or "
        "trec.",
    .value = reciprocal_rank,
};

}  // namespace shapegauge
