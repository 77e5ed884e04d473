// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/segmentation/thick_surface.h"

namespace shapegauge {

/// Options of smooth_boundaries(). The unit of length is the square root of the surface's area.
struct BoundarySmoothingOptions {
  double width = 0.03;     ///< maximum distance by which a border may move, in square roots of the surface's area
  double strength = 0.03;  ///< cost of a flat or convex border per unit of length
  double concavity = 10;   ///< curvature across a concave border that halves its cost, in radians per unit of length
};

/// Names, bounds and help texts of the parameters in BoundarySmoothingOptions (option_parameters.h).
inline constexpr std::array boundary_smoothing_table = {
    with_unit("square roots of the area",
              option_of<&BoundarySmoothingOptions::width>("border_width", {.low = 0, .high = 1},
                                                          "Maximum distance by which smoothing moves borders.")),
    option_of<&BoundarySmoothingOptions::strength>("strength", {.low = 0}, "Cost of a border per length."),
    option_of<&BoundarySmoothingOptions::concavity>("concavity", {.low = 0, .low_open = true},
                                                    "Curvature of a concavity that halves the cost of a border."),
};

/// Smooths the borders between parts: makes them shorter and aligns them with concavities. Returns one label per node.
/// Only nodes within `width` of a border change; alpha_expansion() minimises the cost. Moving a node to another part
/// costs the node's area times its distance from the original border of that part, divided by `width`. A border costs
/// `strength` times its length, and less in concavities. No label disappears. Throws InputError for options out of
/// range, and ArgumentError unless there is one label per node, from 0 on.
std::vector<std::int32_t> smooth_boundaries(const ThickSurface& surface, std::span<const std::int32_t> labels,
                                            const BoundarySmoothingOptions& options);

}  // namespace shapegauge
