#pragma once

#include "shapegauge/metrics/ranked_list.h"

namespace shapegauge {

/// AP, average precision: the mean over all R relevant models of the precision at the rank where each is found. Its
/// mean over queries is mAP.
///
/// Source: Buckley and Voorhees, "Evaluating evaluation measure stability", SIGIR 2000; no interpolation.
/// Caveat: under psb (and in text retrieval) the query is not in the list. Under paper, by analogy with that protocol's
/// other measures, the query is the first of R = C relevant models and found at rank 1 with precision 1, which makes
/// the figure larger.
double average_precision(const RankedList& list);

}  // namespace shapegauge
