// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstddef>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Maximum number of blocks of a grid.
inline constexpr std::size_t max_grid_blocks = std::size_t{1} << 24U;

/// Parameters of a grid and of the points on the surface.
struct GridLayout {
  double offset;   ///< r
  double cell;     ///< edge of a cell
  double spacing;  ///< of the points, in cells
};

/// Returns the parameters for an offset, or for a larger one that keeps within the bounds of memory: max_grid_blocks,
/// and about 6 million points. `bounds` is the shape's bounding box.
GridLayout choose_grid_layout(const Shape& shape, const Eigen::AlignedBox3d& bounds, double offset,
                              double cells_per_offset);

}  // namespace shapegauge
