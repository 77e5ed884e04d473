// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"

namespace shapegauge {

/// Chooses initial centres of clusters among `points` points by k-means++ (Arthur and Vassilvitskii 2007): the first
/// uniformly, each further one with a probability proportional to its squared distance from the nearest centre chosen
/// before. squared_distances(i) returns the vector of squared distances from point i to all points. Returns the indices
/// of `count` points; fewer only if all other points coincide with a centre. `points` and `count` must be at least 1.
template <typename SquaredDistances>
std::vector<Eigen::Index> k_means_seeds(Eigen::Index points, Eigen::Index count, RandomNumbers& random,
                                        const SquaredDistances& squared_distances) {
  std::vector<Eigen::Index> seeds{static_cast<Eigen::Index>(random.below(static_cast<std::uint64_t>(points)))};
  Eigen::VectorXd nearest = Eigen::VectorXd::Constant(points, std::numeric_limits<double>::infinity());
  while (static_cast<Eigen::Index>(seeds.size()) < count) {
    nearest = nearest.cwiseMin(squared_distances(seeds.back()));
    const auto chosen = weighted_index(std::span<const double>(nearest.data(), static_cast<std::size_t>(points)),
                                       random.uniform(0, nearest.sum()));
    if (!chosen) break;
    seeds.push_back(static_cast<Eigen::Index>(*chosen));
  }
  return seeds;
}

}  // namespace shapegauge
