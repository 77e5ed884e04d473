#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/segmentation/thick_surface.h"

namespace shapegauge {

/// Options of boundary smoothing. Lengths are in square roots of the surface's area.
struct BoundarySmoothingOptions {
  double width = 0.03;     ///< maximum distance by which a border may move; at least 0
  double strength = 0.03;  ///< cost of a border per length; at least 0
  double concavity = 10;   ///< curvature of a concavity, in 1 / length, that halves the cost of a border; above 0
};

/// Smooths the borders between parts: makes them shorter and aligns them with concavities. Only nodes near borders
/// change; the cost is minimised by alpha_expansion(). Changing a node's part costs its area times its distance to the
/// new part's old border, relative to `width`. A border costs its length, less in concavities. No label disappears.
/// Throws InputError for options out of range, and ArgumentError unless there is one label a node, from 0 on.
std::vector<std::int32_t> smoothed_boundaries(const ThickSurface& surface, std::span<const std::int32_t> labels,
                                              const BoundarySmoothingOptions& options);

}  // namespace shapegauge
