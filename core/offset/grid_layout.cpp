// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/offset/grid_layout.h"

#include <algorithm>

#include "shapegauge/core/offset/block_grid.h"
#include "shapegauge/core/offset/grid_surface.h"

namespace shapegauge {

namespace {

/// Spacing of the points that determine the closest triangle, in units of r. Distances are too large by at most .25^2 /
/// 16 of r.
constexpr double spacing_by_offset = 0.25;
constexpr double max_spacing = 0.7;
constexpr double max_points = 6e6;

}  // namespace

GridLayout choose_grid_layout(const Shape& shape, const Eigen::AlignedBox3d& bounds, double offset,
                              double cells_per_offset) {
  GridLayout layout{offset, offset / cells_per_offset, spacing_by_offset * cells_per_offset};
  const SurfaceExtent extent(shape);
  while (true) {
    const BlockGrid grid(bounds, layout.offset, layout.cell);
    if ((grid.blocks.cast<double>().array() > 1e6).any() ||
        grid.blocks.cast<double>().prod() > static_cast<double>(max_grid_blocks)) {
      // Enlarges cells first, then the offset.
      layout.cell *= 1.1;
      layout.offset = std::max(layout.offset, 2.5 * layout.cell);
      layout.spacing = spacing_by_offset * layout.offset / layout.cell;
      continue;
    }
    if (extent.max_points(layout.spacing * layout.cell) <= max_points + 2 * extent.pieces) return layout;
    if (layout.spacing * 1.2 <= max_spacing * grid.r) {
      layout.spacing *= 1.2;
    } else {
      layout.cell *= 1.1;
      layout.offset *= 1.1;
    }
  }
}

}  // namespace shapegauge
