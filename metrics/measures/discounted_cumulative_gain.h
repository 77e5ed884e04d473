#pragma once

#include "shapegauge/metrics/ranked_list.h"

namespace shapegauge {

/// DCG, normalised discounted cumulative gain over the whole list: a hit at rank 1 gains 1, a hit at rank i >= 2 gains
/// 1 / log2(i); the sum is divided by the sum of a list that has all its R hits in front.
///
/// Source: Jarvelin and Kekalainen, SIGIR 2000, in the form of Shilane et al., "The Princeton Shape Benchmark", SMI
/// 2004, section 4.
/// Caveat: the discount is that of psbTable, with ranks 1 and 2 counting the same. The "nDCG" of text retrieval divides
/// by log2(i + 1) and gives other figures. It is far from 0 for a random order: hits anywhere gain something.
double discounted_cumulative_gain(const RankedList& list);

}  // namespace shapegauge
