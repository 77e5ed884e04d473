#pragma once

#include "shapegauge/retrieval/rerank.h"

namespace shapegauge {

/// Settings of k_reciprocal().
struct ReciprocalOptions {
  IntegerList neighbours = 16;   ///< 1 to 1000; k1 of the paper; of several, or none ("auto"), the mean is taken
  int expansion_neighbours = 6;  ///< 1 to the greatest of the neighbours; k2, lowered to each of them
  double original = 0.3;         ///< 0 to 1; the share of the original distance, over its largest in the matrix
};

/// k-reciprocal re-ranking (Zhong, Zheng, Cao, Li 2017): the Jaccard distance of models' sets of neighbours that are
/// each other's neighbours, taken up with Gaussian weights, each averaged over its nearest. For several k1 it is the
/// mean of the Jaccard distances. Neighbours join models whose sets have a model in common. Throws InputError for
/// options out of range, and as diffused().
DistanceMatrix k_reciprocal(const DistanceMatrix& distances, const ReciprocalOptions& options = {});

RerankMethod k_reciprocal_method();

}  // namespace shapegauge
