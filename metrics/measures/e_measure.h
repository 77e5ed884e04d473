#pragma once

#include "shapegauge/metrics/measures/measure.h"

namespace shapegauge {

/// E; see its definition below.
double e_measure(const RankedList& list);

inline constexpr MeasureDefinition e_measure_definition{
    .name = "E",
    .title = "e-measure",
    .definition =
        "The harmonic mean of precision and recall among the first k ranks, k = 32 or the whole list "
        "where that is shorter: 2c / (k + R) for c hits among them.",
    .source =
        "van Rijsbergen, Information Retrieval, 1979, chapter 7; Shilane et al., The Princeton Shape "
        "Benchmark, SMI 2004, section 4.",
    .caveat =
        "A perfect method does not reach 1 unless R = k: with classes of 20 it has 0.7451 under psb and, "
        "with the query as one of the 32 results and of the 20 relevant models, 0.7692 under paper.",
    .value = e_measure,
};

}  // namespace shapegauge
