// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>

#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// Maximum number of models of a cached distance matrix: 64 MB. A larger one is computed as fast as it is read.
inline constexpr Eigen::Index max_models_of_cached_distances = 2900;

/// Computes distance_matrix() or reads it from the cache; stores it there, for up to max_models_of_cached_distances
/// signatures. Throws as distance_matrix() does.
DistanceMatrix distances_through_cache(const Signatures& signatures, const std::string& distance, Cache& cache);

/// Computes descriptor_distances() through the cache in the same way.
DistanceMatrix distances_through_cache(const Signatures& features, const Descriptor& descriptor, Cache& cache);

}  // namespace shapegauge
