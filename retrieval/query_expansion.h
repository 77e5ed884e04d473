// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/retrieval/rerank.h"

namespace shapegauge {

/// Options of query_expansion().
struct ExpansionOptions {
  /// Numbers of nearest models whose rows are averaged, from 1 to 1000. The result is the mean over several numbers. An
  /// empty list ("auto") means 4, 5, 7, 10, 14 and 20 (neighbour_counts()).
  IntegerList neighbours = 4;
};

/// Applies average query expansion (Chum et al. 2007) to distances: each model's row becomes the weighted mean
/// of the row itself, with weight 1, and its nearest neighbours' rows, the r-th with weight 1 / (1 + r). The result is
/// then made symmetric. A model is connected (rerank.h) to models at a finite distance from one of its neighbours.
/// Throws InputError for options out of range, and as diffused() does.
DistanceMatrix query_expansion(const DistanceMatrix& distances, const ExpansionOptions& options = {});

/// Returns the entry "query_expansion" of the registry rerank_methods().
RerankMethod query_expansion_method();

}  // namespace shapegauge
