// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/experiments/signatures/distances_through_cache.h"

#include <functional>

#include "shapegauge/experiments/signatures/cache_keys.h"

namespace shapegauge {

namespace {

/// Returns the distances of the signatures from the cache, or by `compute`.
DistanceMatrix cached_distances(const Signatures& signatures, const std::string& distance, Cache& cache,
                                const std::function<DistanceMatrix()>& compute) {
  const bool kept = !cache.folder().empty() && signatures.rows() <= max_models_of_cached_distances;
  if (!kept) return compute();
  return cache.get(EntryKind::distances, distances_key(signatures, distance), compute);
}

}  // namespace

DistanceMatrix distances_through_cache(const Signatures& signatures, const std::string& distance, Cache& cache) {
  return cached_distances(signatures, distance, cache, [&] { return distance_matrix(signatures, distance); });
}

DistanceMatrix distances_through_cache(const Signatures& features, const Descriptor& descriptor, Cache& cache) {
  return cached_distances(features, distance_of(descriptor), cache,
                          [&] { return descriptor_distances(descriptor, features); });
}

}  // namespace shapegauge
