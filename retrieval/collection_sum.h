#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "shapegauge/retrieval/fusion.h"
#include "shapegauge/retrieval/local_scales.h"
#include "shapegauge/retrieval/nearest_models.h"

namespace shapegauge {

/// What a sum of distances (sum_of_distances()) takes from the whole collection: enough to compute its rows one by one,
/// for models of the collection and for others.
struct CollectionSum {
  DistanceScale scale = DistanceScale::none;
  std::vector<double> weights;            ///< by term, those of sum_weights()
  std::vector<double> units;              ///< by term, distance_unit(); none with DistanceScale::local
  std::vector<LocalScales> local_scales;  ///< by term, with DistanceScale::local; empty for a term of weight 0
};

/// The sum of the terms' distances between so many models. The distances pass by, some rows at a time; a median or mean
/// takes the whole matrix. Throws ArgumentError as sum_of_distances() does.
CollectionSum collection_sum(Eigen::Index models, std::span<const RowSource> terms, std::span<const double> weights,
                             SumWeights kind, DistanceScale scale);

/// A model's row of the sum, from its distances to all models of the collection by each term. `member`: its index where
/// it is of the collection; the row then has the bits of sum_of_distances(). A model from elsewhere is scaled by its
/// own nearest in the collection, whose scales and weights stay as they are: a copy of a member has the member's row.
Eigen::VectorXd sum_row(const CollectionSum& sum, std::span<const Eigen::VectorXd> distances, Eigen::Index member = -1);

}  // namespace shapegauge
