// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols: r offset distance, E(r) exterior (exterior_grid.h), x query point.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "shapegauge/core/offset/exterior_grid.h"

namespace shapegauge {

/// Data of the eight cells of a grid around a point: their centres are the corners of a unit cube that contains it.
struct CellsAround {
  /// Indices of the triangles closest to the cells' centres, padded by repetition.
  std::array<std::int32_t, 8> triangles{};
  int count = 0;                  ///< number of the eight cells that have a closest triangle, 0 to 8
  bool touches_exterior = false;  ///< true if one of the eight cells is exterior
};

/// Returns the data of the eight cells whose centres surround the point x, in cell coordinates. Near the border of the
/// grid, uses the outermost cells.
CellsAround cells_around(const ExteriorGrid& exterior, const Eigen::Vector3d& x);

/// Computes the vectors to x from the closest points of the eight triangles in `around`. Returns false if there are no
/// triangles.
inline bool vectors_around(const ExteriorGrid& exterior, const CellsAround& around, const Eigen::Vector3d& x,
                           TriangleTable::Vectors& vectors) {
  if (around.count == 0) return false;
  exterior.surface().triangles.vectors_to(x, around.triangles.data(), vectors);
  return true;
}

/// Returns true if the segment from x to the exterior point `to` is at most 5 cells long and free: no triangle is
/// closer to it than the offset distance r, within a tolerance, up to the first point next to an exterior cell. The
/// tolerance is the depth by which a convex obstacle that touches both ends may bulge into the segment: E(r) extends
/// into narrow valleys between balls that contain no cell centre, and balls are convex.
bool is_connected_to(const ExteriorGrid& exterior, const Eigen::Vector3d& x, const Eigen::Vector3d& to);

}  // namespace shapegauge
