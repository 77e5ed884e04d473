#include "shapegauge/core/offset/exterior_cubes.h"

namespace shapegauge {

BlockCells cubes_at_exterior(const ExteriorGrid& exterior, const Eigen::Vector3i& block) {
  const BlockGrid& grid = exterior.grid();
  const auto cells = [&](int i, int j, int k) {
    const Eigen::Vector3i at = (block + Eigen::Vector3i(i, j, k)).cwiseMin(grid.blocks - Eigen::Vector3i::Ones());
    return exterior.exterior_cells(grid.block_index(at));
  };
  const auto along_x = [&](int j, int k) {
    const BlockCells own = cells(0, j, k);
    return own | (own & ~low_x_cells) >> 1U | (cells(1, j, k) & low_x_cells) << 3U;
  };
  const auto along_y = [&](int k) {
    const BlockCells own = along_x(0, k);
    return own | (own & ~low_y_cells) >> 4U | (along_x(1, k) & low_y_cells) << 12U;
  };
  const BlockCells own = along_y(0);
  return own | own >> 16U | along_y(1) << 48U;
}

}  // namespace shapegauge
