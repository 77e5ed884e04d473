#include "shapegauge/experiments/signatures/distances_through_cache.h"

#include <functional>
#include <utility>

#include "shapegauge/experiments/signatures/cache_records.h"

namespace shapegauge {

namespace {

/// Returns the distances of the signatures from the cache, or by `compute`.
DistanceMatrix cached_distances(const Signatures& signatures, const std::string& distance, Cache& cache,
                                const std::function<DistanceMatrix()>& compute) {
  const bool kept = !cache.folder().empty() && signatures.rows() <= most_models_of_cached_distances;
  const std::string key = kept ? distances_key(signatures, distance) : "";
  if (kept) {
    if (auto distances = cache.lookup(EntryKind::distances, key, read_distances)) {
      cache.count(EntryKind::distances, true);
      return std::move(*distances);
    }
  }
  DistanceMatrix distances = compute();
  cache.count(EntryKind::distances, false);
  if (kept) cache.store(EntryKind::distances, key, distances_record(distances));
  return distances;
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
