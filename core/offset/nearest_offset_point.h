// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols: r offset distance, E(r) exterior, p' raised sample, q closest point of E(r) to p'.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>

#include "shapegauge/core/offset/cells_around.h"
#include "shapegauge/core/offset/point_search.h"

namespace shapegauge {

/// Search for the point q of the exterior E(r) nearest to a raised sample p', from a starting point near q. All points
/// are in cells.
struct OffsetPointTask {
  Eigen::Vector3d p;      ///< sample moved off the surface by about the offset distance (p')
  Eigen::Vector3d start;  ///< starting point, at about the offset distance from the surface
  std::int32_t triangle;  ///< index of a triangle near `start`, which defines the first half-space
  Eigen::Vector3d known;  ///< point found by another search; this search is abandoned near it; infinite for none
  std::optional<Eigen::Vector3d> found;  ///< result: the nearest point; empty if the search fails or is abandoned
};

/// Computes `found` of each task. Each search iterates projections of p' onto the half-spaces tangent to the balls of
/// radius r about the closest points of the triangles nearest to the current point
/// (docs/methods/offset_sdf.md#the-steps-to-q). It runs in a lane of the processor's vectors, in single precision
/// relative to p'. Results do not depend on the other tasks.
void find_nearest_offset_points(const ExteriorGrid& exterior, ClosestTriangles& closest,
                                std::span<OffsetPointTask> tasks);

}  // namespace shapegauge
