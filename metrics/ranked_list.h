#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "shapegauge/metrics/distance_table.h"
#include "shapegauge/metrics/protocol.h"

namespace shapegauge {

/// All models but the query, the nearest first: by distance, and models at equal distance by index. This is the one
/// place where ties are decided. Infinite distances rank last. The query is left out by its index, so a duplicate of it
/// at distance 0 stays, and its own distance to itself plays no part. No distance may be NaN.
std::vector<Eigen::Index> ranked_models(const DistanceTable& distances, Eigen::Index query);

/// All that a measure may know about the answer to one query.
struct RankedList {
  std::vector<bool> hits;          ///< hits[i]: the model at rank i + 1 is of the query's class
  std::size_t relevant = 0;        ///< number of hits in the whole list; at least 1
  bool starts_with_query = false;  ///< rank 1 is the query itself, which counts as a hit
};

/// The list that a protocol judges: under psb all models but the query; under paper the query, by identity, and then
/// the others.
RankedList ranked_list(const DistanceTable& distances, std::span<const int> labels, Eigen::Index query,
                       Protocol protocol);

/// Number of hits among the first `count` ranks, or in the whole list where that is shorter.
std::size_t hits_among_first(const RankedList& list, std::size_t count);

/// The ranks of all hits, counted from 1, ascending.
std::vector<std::size_t> ranks_of_hits(const RankedList& list);

}  // namespace shapegauge
