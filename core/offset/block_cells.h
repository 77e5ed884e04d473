// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>

namespace shapegauge {

/// Set of cells of a block of 4 x 4 x 4 cells, as a bit mask: bit x + 4 y + 16 z is the cell (x, y, z).
using BlockCells = std::uint64_t;
inline constexpr BlockCells all_cells = ~BlockCells{0};  ///< set of all 64 cells of a block

// Cells on the six sides of a block.
inline constexpr BlockCells low_x_cells = 0x1111111111111111;   ///< set of the cells of a block with x = 0
inline constexpr BlockCells high_x_cells = low_x_cells << 3U;   ///< set of the cells of a block with x = 3
inline constexpr BlockCells low_y_cells = 0x000F000F000F000F;   ///< set of the cells of a block with y = 0
inline constexpr BlockCells high_y_cells = low_y_cells << 12U;  ///< set of the cells of a block with y = 3
inline constexpr BlockCells low_z_cells = 0x000000000000FFFF;   ///< set of the cells of a block with z = 0
inline constexpr BlockCells high_z_cells = low_z_cells << 48U;  ///< set of the cells of a block with z = 3

/// Returns the cells of `free` that are connected to `cells` across faces of cells in `free`, within one block.
inline BlockCells flood_fill(BlockCells cells, BlockCells free) {
  cells &= free;
  while (true) {
    BlockCells wider = cells | ((cells & ~high_x_cells) << 1U) | ((cells & ~low_x_cells) >> 1U) |
                       ((cells & ~high_y_cells) << 4U) | ((cells & ~low_y_cells) >> 4U) | (cells << 16U) |
                       (cells >> 16U);
    wider &= free;
    if (wider == cells) return cells;
    cells = wider;
  }
}

/// Returns the cells of a neighbouring block that share a face with the cells `cells` of this block. `side` (0 to 5:
/// -x, +x, -y, +y, -z, +z) is the side of this block on which the neighbour lies.
inline BlockCells cells_across(BlockCells cells, int side) {
  switch (side) {
    case 0:
      return (cells & low_x_cells) << 3U;
    case 1:
      return (cells & high_x_cells) >> 3U;
    case 2:
      return (cells & low_y_cells) << 12U;
    case 3:
      return (cells & high_y_cells) >> 12U;
    case 4:
      return (cells & low_z_cells) << 48U;
    default:
      return (cells & high_z_cells) >> 48U;
  }
}

/// Returns the cells of a block that touch the neighbouring block in a direction: a side, edge or corner of cells. The
/// coordinates of `direction` are -1, 0 or 1.
inline BlockCells cells_touching(const Eigen::Vector3i& direction) {
  constexpr std::array<BlockCells, 3> lowest{low_x_cells, low_y_cells, low_z_cells};
  constexpr std::array<BlockCells, 3> highest{high_x_cells, high_y_cells, high_z_cells};
  BlockCells cells = all_cells;
  for (std::size_t k = 0; k < 3; ++k) {
    const int part = direction[static_cast<Eigen::Index>(k)];
    if (part != 0) cells &= part < 0 ? lowest[k] : highest[k];
  }
  return cells;
}

}  // namespace shapegauge
