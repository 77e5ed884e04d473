// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstddef>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Maximum number of blocks of a BlockGrid, which bounds its memory.
inline constexpr std::size_t max_grid_blocks = std::size_t{1} << 24U;

/// Resolution of the grid around a shape (BlockGrid) and of the points sampled on its surface (GridSurface).
struct GridLayout {
  double offset;   ///< offset distance r, in the shape's units
  double cell;     ///< edge of a cell, in the shape's units
  double spacing;  ///< maximum spacing of the points sampled on the surface, in cells
};

/// Returns the layout for an offset in the shape's units: cells of edge offset / cells_per_offset, and points a quarter
/// of the offset apart. To bound memory, enlarges cells, spacing and, if necessary, the offset until there are at most
/// max_grid_blocks blocks and about 6 million points. `bounds` is the shape's bounding box.
GridLayout choose_grid_layout(const Shape& shape, const Eigen::AlignedBox3d& bounds, double offset,
                              double cells_per_offset);

}  // namespace shapegauge
