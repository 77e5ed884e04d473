// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>

#include "shapegauge/retrieval/distance_matrix.h"

/// Mutual rank of models i and j: the mean of the rank of j among the neighbours of i and the rank of i among the
/// neighbours of j. Depends on the order of distances only, and penalises hubs, the neighbours of many models.

namespace shapegauge {

/// Returns the number of ranks at which distances_at_ranks() samples the distances among `models` models.
Eigen::Index sampled_rank_count(Eigen::Index models);

/// Computes a model's distances to its neighbours of rank 1, 2, ..., 32, 34, ... and the last rank: rank r is followed
/// by r + r / 16, rounded down, or by r + 1. `distances` are the distances to all models. Models at distance 0
/// (duplicates) or at an infinite distance, and the model of index `itself` (-1: none), have no rank. Distances at
/// missing ranks are infinite.
Eigen::RowVectorXd distances_at_ranks(std::span<const double> distances, Eigen::Index itself = -1);

/// Computes log(1 + mutual rank) of one model and each model of a collection. `distances` are the distances from the
/// one model to the collection, `model_at_ranks` its distances_at_ranks(), and `others` the distances_at_ranks() of the
/// collection's models, one row per model.
///
/// The rank of a distance is the number of models not farther than it, interpolated linearly between the ranks of
/// distances_at_ranks(); of a distance 0 it is 0. The result is infinite for an infinite distance.
Eigen::RowVectorXd log_mutual_ranks(std::span<const double> distances, const Eigen::RowVectorXd& model_at_ranks,
                                    const DistanceMatrix& others);

}  // namespace shapegauge
