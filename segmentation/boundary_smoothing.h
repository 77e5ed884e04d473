#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/segmentation/thick_surface.h"

namespace shapegauge {

/// How far borders between parts may move. Lengths are in square roots of the surface's area.
struct BoundarySmoothingOptions {
  double width = 0.03;     ///< how far from its border a part may grow; at least 0 (nothing moves)
  double strength = 0.03;  ///< what a border costs by its length; at least 0
  double concavity = 10;   ///< curvature of a concavity, in 1 / length, in which a border costs half; above 0
};

/// Labels whose borders are shorter and follow concavities: of all labellings that differ near borders only, one of low
/// cost (alpha_expansion). A node that goes to another part costs its area times the way to where that part was, as a
/// share of `width`; a border costs its length, less where the surface is concave. No label disappears. Throws
/// InputError for options out of range and ArgumentError where there is not one label, from 0 on, a node.
std::vector<std::int32_t> smoothed_boundaries(const ThickSurface& surface, std::span<const std::int32_t> labels,
                                              const BoundarySmoothingOptions& options);

}  // namespace shapegauge
