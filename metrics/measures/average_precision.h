#pragma once

#include "shapegauge/metrics/measures/measure.h"

namespace shapegauge {

/// mAP; see its definition below.
double average_precision(const RankedList& list);

inline constexpr MeasureDefinition average_precision_definition{
    .name = "mAP",
    .title = "mean average precision",
    .definition =
        "Of one query (AP): the mean over all R relevant models of the precision at the rank where each "
        "is found, 0 for one that is not in the list.",
    .source =
        "Buckley and Voorhees, Evaluating evaluation measure stability, SIGIR 2000; trec_eval, NIST's "
        "program of the TREC conferences (map).",
    .caveat =
        "No interpolation. Under paper the query is the first of R = C relevant models, found at rank 1 "
        "with precision 1, which makes the figure larger.",
    .value = average_precision,
};

}  // namespace shapegauge
