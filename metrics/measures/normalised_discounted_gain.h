#pragma once

#include "shapegauge/metrics/measures/measure.h"

namespace shapegauge {

/// nDCG; see its definition below.
double normalised_discounted_gain(const RankedList& list);

inline constexpr MeasureDefinition normalised_discounted_gain_definition{
    .name = "nDCG",
    .title = "normalised discounted cumulative gain of text retrieval",
    .definition =
        "A hit at rank i gains 1 / log2(i + 1), over the whole list; the sum is divided by that of a list"
        " with all R hits in front.",
    .source =
        "Jarvelin and Kekalainen, ACM Transactions on Information Systems 20, 2002; trec_eval, NIST's "
        "program of the TREC conferences (ndcg).",
    .caveat =
        "Not the DCG of shape retrieval, which divides by log2(i). Relevance is yes or no here: grades of"
        " a qrels file above 0 all count 1.",
    .value = normalised_discounted_gain,
};

}  // namespace shapegauge
