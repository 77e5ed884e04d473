// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "shapegauge/core/offset/exterior_grid.h"

namespace shapegauge {

/// Data of the eight cells whose centres are the corners of the unit cube that contains a point.
struct CellsAround {
  std::array<std::int32_t, 8> triangles{};  ///< triangle closest to each cell; padded by repetition
  int count = 0;                            ///< number of cells with a triangle
  bool touches_exterior = false;            ///< true if one of the eight is exterior
};

/// Reads the cells around a point (in cells). Near the border of the grid, takes its outermost cells.
CellsAround cells_around(const ExteriorGrid& exterior, const Eigen::Vector3d& x);

/// Computes the vectors from the closest points of the surrounding triangles to x. Returns false if none is known.
inline bool vectors_around(const ExteriorGrid& exterior, const CellsAround& around, const Eigen::Vector3d& x,
                           TriangleTable::Vectors& vectors) {
  if (around.count == 0) return false;
  exterior.surface().triangles.vectors_to(x, around.triangles.data(), vectors);
  return true;
}

/// Returns true if the segment from x to a nearby exterior point is free. A convex obstacle that touches both ends may
/// bulge into it: E(r) extends into narrow valleys between balls that contain no cell centre, and balls are convex.
bool is_connected_to(const ExteriorGrid& exterior, const Eigen::Vector3d& x, const Eigen::Vector3d& to);

}  // namespace shapegauge
