#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/segmentation/surface_graph.h"

namespace shapegauge {

/// How a surface is cut into patches.
struct PatchOptions {
  int count = 50;          ///< patches wanted (L in the paper), at least 1
  int rounds = 3;          ///< how often the patches move to their centres, at least 0
  std::uint64_t seed = 1;  ///< of the first patch's place
};

/// Cuts a surface into compact patches: for each node the number of its patch, from 0 on without gaps.
///
/// Patches grow from centres along the links, each node to the centre to which the way costs the least. Centres start
/// as far from each other as possible (each the farthest node from those before) and move to the middle of their
/// patches after each round. `costs` has the cost of every link, in the order of the graph's links, both ways alike;
/// without, a link costs its distance. There are more patches than wanted where the surface has more components, and
/// fewer where it has fewer nodes. A patch is connected.
///
/// Throws InputError for options out of range and ArgumentError where the number of costs is wrong.
std::vector<std::int32_t> patches(const SurfaceGraph& graph, const PatchOptions& options,
                                  std::span<const double> costs = {});

}  // namespace shapegauge
