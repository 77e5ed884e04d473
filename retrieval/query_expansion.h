#pragma once

#include "shapegauge/retrieval/rerank.h"

namespace shapegauge {

/// Settings of query_expansion().
struct ExpansionOptions {
  IntegerList neighbours = 4;  ///< 1 to 1000; of several, or none ("auto"), the mean is taken
};

/// Average query expansion (Chum et al. 2007), on distances: each row becomes the mean of its own and its nearest
/// neighbours' rows, the r-th with weight 1 / (1 + r); then made symmetric. Neighbours join a model to those at a
/// finite distance from one of them. Throws InputError for options out of range, and as diffused().
DistanceMatrix query_expansion(const DistanceMatrix& distances, const ExpansionOptions& options = {});

RerankMethod query_expansion_method();

}  // namespace shapegauge
