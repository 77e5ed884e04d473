// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>

#include "shapegauge/core/offset/exterior_grid.h"
#include "shapegauge/core/offset/point_search.h"

namespace shapegauge {

/// Ray from a point of the surface to E(r), which is at least r away. In cells.
struct OffsetExitTask {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;  ///< unit vector
  double exit = 0;            ///< result: distance along the ray
};

/// Solves tasks. Each runs in a lane of the processor's vectors, in single precision. Results do not depend on the
/// other tasks.
void find_offset_exits(const ExteriorGrid& exterior, ClosestTriangles& closest, std::span<OffsetExitTask> tasks);

}  // namespace shapegauge
