#pragma once

#include <Eigen/Core>

#include "shapegauge/core/offset/block_cells.h"
#include "shapegauge/core/offset/exterior_grid.h"

namespace shapegauge {

/// Returns the cubes between the centres of a block's cells and their upper neighbours that have an exterior corner.
/// Each is the bit of its lowest cell.
BlockCells cubes_at_exterior(const ExteriorGrid& exterior, const Eigen::Vector3i& block);

}  // namespace shapegauge
