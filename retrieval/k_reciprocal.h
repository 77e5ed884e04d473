#pragma once

#include "shapegauge/retrieval/rerank.h"

namespace shapegauge {

/// Options of k_reciprocal().
struct ReciprocalOptions {
  IntegerList neighbours =
      16;  ///< 1 to 1000; k1 of the paper; mean over several, or over neighbour_counts() of none ("auto")
  int expansion_neighbours = 6;  ///< 1 to the largest of the neighbours; k2 of the paper, limited to each of them
  double original = 0.3;         ///< 0 to 1; weight of the original distance, divided by its maximum in the matrix
};

/// Re-ranks by k-reciprocal neighbours (Zhong, Zheng, Cao, Li 2017): the Jaccard distance of models' sets of mutual
/// neighbours, with Gaussian weights, each averaged over its nearest. For several k1 it is the mean of the Jaccard
/// distances. Models whose sets intersect are connected (rerank.h). Throws InputError for options out of range, and as
/// diffused() does.
DistanceMatrix k_reciprocal(const DistanceMatrix& distances, const ReciprocalOptions& options = {});

RerankMethod k_reciprocal_method();

}  // namespace shapegauge
