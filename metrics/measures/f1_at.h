#pragma once

#include "shapegauge/metrics/measures/measure.h"

namespace shapegauge {

/// F1@k; see its definition below.
double f1_at(const RankedList& list, std::size_t k);

inline constexpr MeasureDefinition f1_at_definition{
    .name = "F1@k",
    .title = "F1 at k",
    .definition = "The harmonic mean of P@k and R@k: 2c / (k + R) for c hits among the first k ranks.",
    .source = "van Rijsbergen, Information Retrieval, 1979, chapter 7.",
    .caveat = "Does not reach 1 unless R = k. F1@32 is E where a list has 32 ranks or more.",
    .value_at = f1_at,
};

}  // namespace shapegauge
