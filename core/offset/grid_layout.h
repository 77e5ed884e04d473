// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstddef>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Maximum number of blocks of a BlockGrid, which bounds its memory.
inline constexpr std::size_t max_grid_blocks = std::size_t{1} << 24U;

/// Resolution of a BlockGrid and of the points sampled on the surface (GridSurface).
struct GridLayout {
  double offset;   ///< offset distance r, in the shape's units
  double cell;     ///< edge of a cell, in the shape's units
  double spacing;  ///< maximum spacing of the sampled points, in cells
};

/// Returns the layout for an offset, with cells of edge offset / cells_per_offset. If memory does not suffice
/// (max_grid_blocks, and about 6 million points), increases spacing, cells and offset until it does. `bounds` is the
/// shape's bounding box.
GridLayout choose_grid_layout(const Shape& shape, const Eigen::AlignedBox3d& bounds, double offset,
                              double cells_per_offset);

}  // namespace shapegauge
