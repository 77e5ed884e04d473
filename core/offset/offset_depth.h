// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols: r offset distance, d(x) distance from x to the surface, O(r) points x with d(x) <= r, E(r) exterior.
#pragma once

#include <Eigen/Core>
#include <span>

#include "shapegauge/core/offset/exterior_grid.h"
#include "shapegauge/core/offset/point_search.h"

namespace shapegauge {

/// Relative tolerance of the offset surface: a point is not covered if its distance from the surface is at least (1 -
/// surface_slack) times the offset distance.
inline constexpr double surface_slack = 1e-3;

/// Query of the depth of a point x inside the offset solid O(r).
struct OffsetDepthTask {
  Eigen::Vector3d x;         ///< query point, in cells
  bool is_exterior = false;  ///< result: true if the point x belongs to the exterior E(r)
  /// Result: 1 - distance of x from the surface / offset distance, at least 0; 1 if x is exterior or no surrounding
  /// cell has a triangle.
  double depth = 0;
};

/// Computes `is_exterior` and `depth` of each task, one task in each lane of the processor's vectors. Results do not
/// depend on the other tasks. Depths of at least blend_depth are approximate.
void find_offset_depths(const ExteriorGrid& exterior, ClosestTriangles& closest, std::span<OffsetDepthTask> tasks);

}  // namespace shapegauge
