// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/segmentation/thick_surface.h"

namespace shapegauge {

/// Options of boundary smoothing. Lengths are in square roots of the surface's area.
struct BoundarySmoothingOptions {
  double width = 0.03;     ///< maximum distance by which a border may move
  double strength = 0.03;  ///< cost of a border per length
  double concavity = 10;   ///< curvature of a concavity, in 1 / length, that halves the cost of a border
};

/// Parameters of BoundarySmoothingOptions.
inline constexpr std::array boundary_smoothing_table = {
    with_unit("square roots of the area",
              option_of<&BoundarySmoothingOptions::width>("border_width", {.low = 0, .high = 1},
                                                          "Maximum distance that smoothing moves borders.")),
    option_of<&BoundarySmoothingOptions::strength>("strength", {.low = 0}, "Cost of a border per length."),
    option_of<&BoundarySmoothingOptions::concavity>("concavity", {.low = 0, .low_open = true},
                                                    "Curvature of a concavity that halves the cost of a border."),
};

/// Smooths the borders between parts: makes them shorter and aligns them with concavities. Only nodes near borders
/// change; the cost is minimised by alpha_expansion(). Changing a node's part costs its area times its distance to the
/// new part's old border, relative to `width`. A border costs its length, less in concavities. No label disappears.
/// Throws InputError for options out of range, and ArgumentError unless there is one label per node, from 0 on.
std::vector<std::int32_t> smooth_boundaries(const ThickSurface& surface, std::span<const std::int32_t> labels,
                                            const BoundarySmoothingOptions& options);

}  // namespace shapegauge
