// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/segmentation/regions.h"
#include "shapegauge/segmentation/thick_surface.h"

namespace shapegauge {

/// Computes the costs of all links of the surface's graph, in the order of the links, for patches(), such that the
/// patches' borders follow concavities and changes of thickness.
std::vector<double> patch_costs(const ThickSurface& surface);

/// Computes the statistics of patches of a surface for merge_regions(). `patch[i]` is the region of node i, from 0 on,
/// or -1 for none; regions are adjacent if their nodes are. About `samples` samples are spread over the surface, at
/// least one per patch; visibility is tested between all pairs, inside and outside the shape. A surface narrower than
/// rays resolve (an area below 1e-7 squared diagonals) has no statistics of rays and sample pairs. Parallel over
/// samples in the calling TBB arena, with the same bytes on any number of threads.
Regions surface_regions(const ThickSurface& surface, std::span<const std::int32_t> patch, int samples);

}  // namespace shapegauge
