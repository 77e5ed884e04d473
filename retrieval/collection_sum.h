// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "shapegauge/retrieval/fusion.h"
#include "shapegauge/retrieval/local_scales.h"
#include "shapegauge/retrieval/mutual_ranks.h"
#include "shapegauge/retrieval/nearest_models.h"

namespace shapegauge {

/// Collection statistics of a sum of distances (sum_of_distances()): enough to compute its rows one by one, for models
/// of the collection and for others.
struct CollectionSum {
  DistanceScale scale = DistanceScale::none;
  std::vector<double> weights;            ///< per term, those of sum_weights()
  std::vector<double> units;              ///< per term: distance_unit(), or 1
  std::vector<LocalScales> local_scales;  ///< per term with DistanceScale::local or ranks and a positive weight
  std::vector<DistanceMatrix> at_ranks;   ///< per term with DistanceScale::ranks: distances_at_ranks() of each model
};

/// Computes the statistics of a weighted sum of the terms' distances. Distances are streamed in blocks of rows, at most
/// twice, except that a median or mean needs the whole matrix. Throws ArgumentError as sum_of_distances() does.
CollectionSum collection_sum(Eigen::Index models, std::span<const RowSource> terms, std::span<const double> weights,
                             SumWeights kind, DistanceScale scale);

/// Computes a model's row of the sum from its distances, by each term, to all models of the collection. `member` is its
/// index if it belongs to the collection; the row then equals that of sum_of_distances() to the bit. Another model is
/// scaled or ranked by its own nearest in the collection, whose scales, ranks and weights stay unchanged: a copy of a
/// member has the member's row.
Eigen::VectorXd sum_row(const CollectionSum& sum, std::span<const Eigen::VectorXd> distances, Eigen::Index member = -1);

}  // namespace shapegauge
