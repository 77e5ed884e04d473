// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>

#include "shapegauge/segmentation/regions.h"

namespace shapegauge {

/// Function that returns the affinity of two adjacent regions, given by their numbers: any number but NaN. The pair
/// with the highest affinity is merged first.
using RegionAffinity = std::function<double(const Regions&, std::int32_t, std::int32_t)>;

/// Options of merge_regions().
struct MergingOptions {
  double min_affinity = 0.5;  ///< minimum affinity at which two regions are merged; ignored if `parts` is not 0
  std::int32_t parts = 0;     ///< number of regions at which merging stops; 0: min_affinity determines it
};

/// Merges adjacent regions greedily by highest affinity (ties: the pair with the lower region numbers). A merged
/// region has the lower number of the two, and its affinities are recomputed.
void merge_regions(Regions& regions, const RegionAffinity& affinity, const MergingOptions& options);

}  // namespace shapegauge
