// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols: r offset distance, E(r) exterior, q' exit of the ray into E(r).
#pragma once

#include <Eigen/Core>
#include <span>

#include "shapegauge/core/offset/exterior_grid.h"
#include "shapegauge/core/offset/point_search.h"

namespace shapegauge {

/// Query of the point q' where a ray from a sample on the surface enters the exterior E(r). Points are in cells.
struct OffsetExitTask {
  Eigen::Vector3d origin;     ///< sample on the surface, at least the offset distance from the exterior
  Eigen::Vector3d direction;  ///< unit vector along the ray
  /// Result: distance along the ray from the origin to the point where it enters the exterior, in cells.
  double exit = 0;
};

/// Computes `exit` of each task. Each ray runs in a lane of the processor's vectors, in single precision. Results do
/// not depend on the other tasks.
void find_offset_exits(const ExteriorGrid& exterior, ClosestTriangles& closest, std::span<OffsetExitTask> tasks);

}  // namespace shapegauge
