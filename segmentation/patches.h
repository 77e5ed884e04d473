// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/segmentation/surface_graph.h"

namespace shapegauge {

/// Options of patches().
struct PatchOptions {
  int count = 50;          ///< number of patches (L of Chen et al. 2018), at least 1
  std::uint64_t seed = 1;  ///< seed of the random node at which the first patch starts
};

/// Minimum area of a patch or part, as a fraction of the mean area of patches: smaller ones are merged as slivers.
inline constexpr double min_patch_fraction = 0.1;

/// Divides a surface into compact, connected patches: returns a patch number for each node, from 0 on without gaps.
///
/// Patches grow from centres along the links; each node joins the centre with the cheapest path. Centres start in
/// farthest-point order and move to the middle of their patches, in three rounds. `costs` has the symmetric cost of
/// every link, in the order of the graph's links; by default, a link costs its distance. There are more patches than
/// requested if the surface has more components, and fewer if it has fewer nodes.
///
/// Throws InputError for options out of range and ArgumentError for a wrong number of costs.
std::vector<std::int32_t> patches(const SurfaceGraph& graph, const PatchOptions& options,
                                  std::span<const double> costs = {});

}  // namespace shapegauge
