#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/segmentation/regions.h"
#include "shapegauge/segmentation/thick_surface.h"

namespace shapegauge {

/// The costs of a surface's links for patches() whose borders run where the surface is concave or its thickness
/// changes.
std::vector<double> patch_costs(const ThickSurface& surface);

/// Measures patches of a surface for merging: `patch[i]`, from 0 on, is the region of node i, or -1 where it is in
/// none, and regions are neighbours where nodes of theirs are. About so many `samples` are spread over the surface, at
/// least one a patch; each looks for all others along straight lines, inside of the shape and outside. Parallel over
/// samples in the calling TBB arena; the same input gives the same bytes on any number of threads.
Regions surface_regions(const ThickSurface& surface, std::span<const std::int32_t> patch, int samples);

}  // namespace shapegauge
