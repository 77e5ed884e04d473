#pragma once

#include "shapegauge/metrics/ranked_list.h"

namespace shapegauge {

/// E, e-measure: the harmonic mean of precision and recall among the first k ranks, k = 32 or the whole list where that
/// is shorter: 2c / (k + R) for c hits among them and R relevant models in all; 0 where c = 0.
///
/// Source: van Rijsbergen, "Information Retrieval", 1979, chapter 7; as used by Shilane et al., "The Princeton Shape
/// Benchmark", SMI 2004, section 4.
/// Caveat: a perfect method does not reach 1 unless R = k: with classes of 20 its E is 0.7451 under psb and, with the
/// query as one of the 32 results and of the 20 relevant models, 0.7692 under paper.
double e_measure(const RankedList& list);

}  // namespace shapegauge
