// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/retrieval/rerank.h"

namespace shapegauge {

/// Options of k_reciprocal().
struct ReciprocalOptions {
  /// Numbers of neighbours, k1 of the paper, from 1 to 1000. The result is the mean over several; of an empty list
  /// ("auto"), over neighbour_counts().
  IntegerList neighbours = 16;
  int expansion_neighbours = 6;  ///< k2 of the paper: from 1 to the largest k1; at most the current k1 is used
  double original = 0.3;         ///< 0 to 1; weight of the original distance, divided by its maximum in the matrix
};

/// Re-ranks by k-reciprocal neighbours (Zhong, Zheng, Cao, Li 2017): the Jaccard distance of models' sets of mutual
/// neighbours, with Gaussian weights, each averaged over its nearest. For several k1 it is the mean of the Jaccard
/// distances. Models whose sets intersect are connected (rerank.h). Throws InputError for options out of range, and as
/// diffused() does.
DistanceMatrix k_reciprocal(const DistanceMatrix& distances, const ReciprocalOptions& options = {});

RerankMethod k_reciprocal_method();

}  // namespace shapegauge
