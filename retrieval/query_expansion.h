// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/retrieval/rerank.h"

namespace shapegauge {

/// Options of query_expansion().
struct ExpansionOptions {
  IntegerList neighbours = 4;  ///< 1 to 1000; mean over several, or over neighbour_counts() of none ("auto")
};

/// Applies average query expansion (Chum et al. 2007) to distances: each row becomes the mean of its own and its
/// nearest neighbours' rows, the r-th with weight 1 / (1 + r). The result is then made symmetric. A model is
/// connected (rerank.h) to those at a finite distance from one of its neighbours. Throws InputError for options out of
/// range, and as diffused() does.
DistanceMatrix query_expansion(const DistanceMatrix& distances, const ExpansionOptions& options = {});

RerankMethod query_expansion_method();

}  // namespace shapegauge
