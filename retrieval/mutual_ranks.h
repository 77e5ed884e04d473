// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>

#include "shapegauge/retrieval/distance_matrix.h"

/// Mutual ranks: the mean of the rank of model j among the neighbours of i and that of i among the neighbours of j.
/// They depend on the order of distances only, and count a neighbour less if it is the neighbour of many.

namespace shapegauge {

/// Returns the number of distances_at_ranks() among that many models.
Eigen::Index count_of_ranks(Eigen::Index models);

/// Computes a model's distances to its neighbours of rank 1, 2, ..., 32, 34, ... and the last: each rank is a sixteenth
/// above the one before, rounded down, or the next number. Models at distance 0 are duplicates without a rank, as are
/// models at an infinite distance and the entry `itself`. If ranks are missing, the distances are infinite.
Eigen::RowVectorXd distances_at_ranks(std::span<const double> distances, Eigen::Index itself = -1);

/// Computes log(1 + mutual rank) of a model and each model of a collection. `distances` are those between them,
/// `own` the model's distances_at_ranks(), and `others` those of the collection, one row per model.
///
/// The rank of a distance is the number of models not farther than it, interpolated linearly between the ranks of
/// distances_at_ranks(); of a distance 0 it is 0. The result is infinite for an infinite distance.
Eigen::RowVectorXd log_mutual_ranks(std::span<const double> distances, const Eigen::RowVectorXd& own,
                                    const DistanceMatrix& others);

}  // namespace shapegauge
