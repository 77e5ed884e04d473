// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>

#include "shapegauge/core/offset/cells_around.h"
#include "shapegauge/core/offset/point_search.h"

namespace shapegauge {

/// Search for the point of E(r) nearest to p in the neighbourhood of a starting point. All points are in cells.
struct OffsetPointTask {
  Eigen::Vector3d p;
  Eigen::Vector3d start;  ///< at a distance of about r from the surface
  std::int32_t triangle;  ///< triangle of the first half-space
  Eigen::Vector3d known;  ///< result of another search, near which this one is abandoned; infinite if there is none
  std::optional<Eigen::Vector3d> found;  ///< result; nothing if the search fails or is abandoned
};

/// Solves tasks: iterates projections of p onto the half-spaces tangent to the balls about the triangles nearest to the
/// current point (docs/methods/offset_sdf.md#the-steps-to-q). Each task runs in a lane of the processor's vectors, in
/// single precision relative to p. Results do not depend on the other tasks.
void find_nearest_offset_points(const ExteriorGrid& exterior, ClosestTriangles& closest,
                                std::span<OffsetPointTask> tasks);

}  // namespace shapegauge
