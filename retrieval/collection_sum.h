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
  std::vector<NearestModels> nearest;     ///< by term, nearest_for_weights() of each model, where they are needed
  std::vector<Eigen::VectorXd> means;     ///< by term, mean_distance_to_nearest() of each model, likewise
};

/// The sum of a collection as it was, of which some models are still there.
struct EarlierSum {
  const CollectionSum& sum;
  std::vector<Eigen::Index> places;  ///< by model now its index then, -1 for a new one; those of others ascend
  std::vector<bool> unchanged;       ///< by term: models that are still there have the distances that they had
};

/// The sum of the terms' distances between so many models. The distances pass by, some rows at a time; a median or mean
/// takes the whole matrix. With an earlier sum of the same terms, only the rows of models are asked for that are new,
/// or that have lost one of their nearest; the result is the same. Throws ArgumentError as sum_of_distances() does.
CollectionSum collection_sum(Eigen::Index models, std::span<const RowSource> terms, std::span<const double> weights,
                             SumWeights kind, DistanceScale scale, const EarlierSum* earlier = nullptr);

/// A model's row of the sum, from its distances to all models of the collection by each term. `member`: its index where
/// it is of the collection; the row then has the bits of sum_of_distances(). A model from elsewhere is scaled by its
/// own nearest in the collection, whose scales and weights stay as they are: a copy of a member has the member's row.
Eigen::VectorXd sum_row(const CollectionSum& sum, std::span<const Eigen::VectorXd> distances, Eigen::Index member = -1);

}  // namespace shapegauge
