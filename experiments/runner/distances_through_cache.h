#pragma once

#include <string>

#include "shapegauge/experiments/cache/cache.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// distance_matrix(), taken from the cache where it is there, and else kept there. A matrix of more than 64 MB (2,900
/// shapes) is not kept: it is computed as fast as it is read. Throws as distance_matrix() does.
DistanceMatrix distances_through_cache(const Signatures& signatures, const std::string& distance, Cache& cache);

}  // namespace shapegauge
