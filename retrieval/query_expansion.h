// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/retrieval/rerank.h"

namespace shapegauge {

/// Options of query_expansion().
struct ExpansionOptions {
  IntegerList neighbours = 4;  ///< numbers of neighbours, 1 to 1000; results are averaged; "auto": neighbour_counts()
};

/// Applies average query expansion (Chum et al. 2007) to distances: each model's row becomes the weighted mean
/// of the row itself, with weight 1, and its nearest neighbours' rows, the r-th with weight 1 / (1 + r). The result is
/// then made symmetric. A model is connected (rerank.h) to models at a finite distance from one of its neighbours.
/// Throws InputError for options out of range, and as diffused() does.
DistanceMatrix query_expansion(const DistanceMatrix& distances, const ExpansionOptions& options = {});

RerankMethod query_expansion_method();

}  // namespace shapegauge
