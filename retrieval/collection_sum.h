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

/// Statistics of a collection from which sum_row() computes single rows of a weighted sum of distance matrices
/// (sum_of_distances()), for models of the collection and for other models. A term is one matrix of the sum.
struct CollectionSum {
  DistanceScale scale = DistanceScale::none;  ///< normalisation of each matrix
  std::vector<double> weights;                ///< weight of each term in the sum (sum_weights())
  std::vector<double> units;              ///< divisor of each term's distances, distance_unit(); 1 with local scales
  std::vector<LocalScales> local_scales;  ///< per term: local scales of the models; empty without local scaling
  std::vector<DistanceMatrix> at_ranks;   ///< per term: distances of each model at sampled ranks, models x ranks
                                          ///< (distances_at_ranks()); empty unless scaled by ranks
};

/// Computes the statistics of a weighted sum of distance matrices of `models` models. Each term supplies the rows of
/// one matrix. Distances are streamed in blocks of rows, at most twice, except that a median or mean needs the whole
/// matrix. Throws ArgumentError as sum_of_distances() does.
CollectionSum collection_sum(Eigen::Index models, std::span<const RowSource> terms, std::span<const double> weights,
                             SumWeights kind, DistanceScale scale);

/// Computes a model's row of the weighted sum. `distances` holds, per term, the model's distances to all models of the
/// collection. `member` is the model's index in the collection, -1 for another model. The row of a member equals that
/// of sum_of_distances() to the bit. A model outside the collection is scaled or ranked by its nearest models in the
/// collection; the collection's scales, ranks and weights stay unchanged. A copy of a member thus has the member's row.
Eigen::VectorXd sum_row(const CollectionSum& sum, std::span<const Eigen::VectorXd> distances, Eigen::Index member = -1);

}  // namespace shapegauge
