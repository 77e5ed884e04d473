// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>

#include "shapegauge/core/offset/exterior_grid.h"
#include "shapegauge/core/offset/point_search.h"

namespace shapegauge {

/// Tolerance of the offset surface, in units of r.
inline constexpr double surface_slack = 1e-3;

/// Place, in cells, with its depth inside O(r).
struct OffsetDepthTask {
  Eigen::Vector3d x;
  bool is_exterior = false;  ///< result
  double depth = 0;          ///< result, in units of r; 1 if no surrounding cell has a triangle
};

/// Solves tasks, one in each lane of the processor's vectors. Results do not depend on the other tasks. Depths of at
/// least blend_depth are approximate.
void find_offset_depths(const ExteriorGrid& exterior, ClosestTriangles& closest, std::span<OffsetDepthTask> tasks);

}  // namespace shapegauge
