// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>

#include "shapegauge/segmentation/regions.h"

namespace shapegauge {

/// Returns the affinity of two adjacent regions: a number, not NaN; higher means that they belong together.
using RegionAffinity = std::function<double(const Regions&, std::int32_t, std::int32_t)>;

/// Options of merge_regions().
struct MergingOptions {
  double min_affinity = 0.5;  ///< regions of a lower affinity are not merged, unless `parts` is given
  std::int32_t parts = 0;  ///< number of regions to reach, as far as adjacency permits; 0: determined by min_affinity
};

/// Merges adjacent regions greedily by highest affinity (ties: the pair of lower numbers). Affinities of a merged
/// region are recomputed. The merged region has the lower number.
void merge_regions(Regions& regions, const RegionAffinity& affinity, const MergingOptions& options);

}  // namespace shapegauge
