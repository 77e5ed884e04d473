#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "shapegauge/retrieval/fusion.h"
#include "shapegauge/retrieval/local_scales.h"
#include "shapegauge/retrieval/nearest_models.h"

namespace shapegauge {

/// Collection statistics of a sum of distances (sum_of_distances()): enough to compute its rows one by one, for models
/// of the collection and for others.
struct CollectionSum {
  DistanceScale scale = DistanceScale::none;
  std::vector<double> weights;            ///< by term, those of sum_weights()
  std::vector<double> units;              ///< by term: distance_unit() or spread_of_scaled(), or 1
  std::vector<LocalScales> local_scales;  ///< by term where is_local(scale); empty for a term of weight 0
  std::vector<NearestModels> nearest;     ///< by term: nearest_for_weights() of each model, if needed
  std::vector<Eigen::VectorXd> means;     ///< by term: mean_distance_to_nearest() of each model, if needed
};

/// Sum of an earlier state of the collection, some of whose models remain.
struct EarlierSum {
  const CollectionSum& sum;
  std::vector<Eigen::Index> places;  ///< by present model: its earlier index, ascending; -1 for a new model
  std::vector<bool> unchanged;       ///< by term: true if the distances between remaining models are the same
};

/// Computes the statistics of a weighted sum of the terms' distances. Distances are streamed in blocks of rows, except
/// that a median or mean needs the whole matrix. With an earlier sum of the same terms, only requests the rows of new
/// models, of models that lost one of their nearest, and of spread_of_scaled(); the result is the same. Throws
/// ArgumentError as sum_of_distances() does.
CollectionSum collection_sum(Eigen::Index models, std::span<const RowSource> terms, std::span<const double> weights,
                             SumWeights kind, DistanceScale scale, const EarlierSum* earlier = nullptr);

/// Computes a model's row of the sum from its distances, by each term, to all models of the collection. `member` is its
/// index if it belongs to the collection; the row then equals that of sum_of_distances() to the bit. Another model is
/// scaled by its own nearest in the collection, whose scales and weights stay unchanged: a copy of a member has the
/// member's row.
Eigen::VectorXd sum_row(const CollectionSum& sum, std::span<const Eigen::VectorXd> distances, Eigen::Index member = -1);

}  // namespace shapegauge
