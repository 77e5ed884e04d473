// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/retrieval/rerank.h"

namespace shapegauge {

/// Options of k_reciprocal().
struct ReciprocalOptions {
  /// Numbers of neighbours, k1 of Zhong et al. 2017, from 1 to 1000. The result is the mean over several k1. An empty
  /// list ("auto") means 4, 5, 7, 10, 14 and 20 (neighbour_counts()).
  IntegerList neighbours = 16;
  int expansion_neighbours = 6;  ///< number k2 of nearest models over which sets are averaged: 1 to the largest k1
  double original = 0.3;         ///< weight of the original distance, divided by its maximum in the matrix; from 0 to 1
};

/// Re-ranks by k-reciprocal neighbours (Zhong, Zheng, Cao, Li 2017): the Jaccard distance between the models'
/// sets of mutual neighbours. Neighbours at distance d have the weight exp(-d / mean d), and each set is averaged over
/// the k2 nearest models, the model included. For several k1 the result is the mean of the Jaccard distances. Models
/// whose sets intersect are connected (rerank.h). Throws InputError for options out of range, and as diffused() does.
DistanceMatrix k_reciprocal(const DistanceMatrix& distances, const ReciprocalOptions& options = {});

/// Returns the entry "k_reciprocal" of the registry rerank_methods().
RerankMethod k_reciprocal_method();

}  // namespace shapegauge
