#pragma once

#include "shapegauge/metrics/measures/measure.h"

namespace shapegauge {

/// DCG; see its definition below.
double discounted_cumulative_gain(const RankedList& list);

inline constexpr MeasureDefinition discounted_cumulative_gain_definition{
    .name = "DCG",
    .title = "discounted cumulative gain, normalised",
    .definition =
        "A hit at rank 1 gains 1, a hit at rank i >= 2 gains 1 / log2(i), over the whole list; the sum is"
        " divided by that of a list with all R hits in front.",
    .source =
        "Jarvelin and Kekalainen, SIGIR 2000, in the form of Shilane et al., The Princeton Shape "
        "Benchmark, SMI 2004, section 4.",
    .caveat =
        "Ranks 1 and 2 count the same; nDCG divides by log2(i + 1) and gives other figures. Far from 0 "
        "for a random order: hits anywhere gain something.",
    .value = discounted_cumulative_gain,
};

}  // namespace shapegauge
