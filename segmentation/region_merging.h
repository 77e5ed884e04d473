#pragma once

#include <cstdint>
#include <functional>

#include "shapegauge/segmentation/regions.h"

namespace shapegauge {

/// How far two neighbouring regions belong together, the higher the more: a number, not NaN.
using RegionAffinity = std::function<double(const Regions&, std::int32_t, std::int32_t)>;

/// When to stop merging.
struct MergingOptions {
  double least_affinity = 0.5;  ///< regions of a lower affinity stay apart; a given number of parts goes before
  std::int32_t parts = 0;       ///< regions wanted: neither more nor fewer, as far as neighbours go; 0: as many as come
};

/// Merges neighbouring regions, always the two of the highest affinity, which is asked for anew for the pairs of the
/// region that came of it. Of equal affinities the pair of lower numbers comes first. The lower number stays.
void merge_regions(Regions& regions, const RegionAffinity& affinity, const MergingOptions& options);

}  // namespace shapegauge
