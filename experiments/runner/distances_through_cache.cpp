#include "shapegauge/experiments/runner/distances_through_cache.h"

#include <utility>

#include "shapegauge/experiments/cache/cache_keys.h"
#include "shapegauge/experiments/cache/cache_records.h"

namespace shapegauge {

namespace {

constexpr Eigen::Index most_shapes_kept = 2900;

}  // namespace

DistanceMatrix distances_through_cache(const Signatures& signatures, const std::string& distance, Cache& cache) {
  const bool kept = !cache.folder().empty() && signatures.rows() <= most_shapes_kept;
  const std::string key = kept ? distances_key(signatures, distance) : "";
  if (kept) {
    if (auto distances = cache.find(EntryKind::distances, key, read_distances)) {
      cache.count(EntryKind::distances, true);
      return std::move(*distances);
    }
  }
  DistanceMatrix distances = distance_matrix(signatures, distance);
  cache.count(EntryKind::distances, false);
  if (kept) cache.store(EntryKind::distances, key, distances_record(distances));
  return distances;
}

}  // namespace shapegauge
