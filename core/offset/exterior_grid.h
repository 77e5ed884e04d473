// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols: h edge of a cell, r offset distance, E(r) exterior, block of 4 x 4 x 4 cells (block_grid.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "shapegauge/core/offset/grid_surface.h"

namespace shapegauge {

/// Exterior E(r) of a shape at the resolution of a grid: the cells whose centres are farther than r from the surface
/// and which are connected across faces, through such cells, to the border of the grid.
///
/// Nothing leaks through a wall: free centres on different sides of it are at least 2r apart, and h, the edge of a
/// cell, is less than r. A passage is always open if its half-width exceeds r by sqrt(3)/2 h, and never if its
/// half-width is less than r - h^2 / 8r.
class ExteriorGrid {
 public:
  /// Marks the cells of E(r) by a flood fill. Each cell of the blocks near the offset surface, boundary(), stores its
  /// nearest triangle; these blocks extend at least `band` cells outwards. Keeps references to grid and surface.
  ExteriorGrid(const BlockGrid& grid, const GridSurface& surface, double band, bool parallel);

  [[nodiscard]] const BlockGrid& grid() const { return grid_; }
  [[nodiscard]] const GridSurface& surface() const { return surface_; }
  /// Returns the blocks near the offset surface (BlockKind::mixed).
  [[nodiscard]] const std::vector<BoundaryBlock>& boundary() const { return boundary_; }
  /// Returns the bit mask of the exterior cells of a block, given its index in boundary().
  [[nodiscard]] std::uint64_t boundary_cells(std::size_t boundary_index) const { return exterior_[boundary_index]; }

  static constexpr std::int32_t all_exterior = -1;   ///< state of a block whose cells are all exterior
  static constexpr std::int32_t none_exterior = -2;  ///< state, like any smaller one, of a block without exterior cells
  /// Returns the state of a block of the grid: its index in boundary() if it is mixed, otherwise all_exterior,
  /// none_exterior or a smaller number.
  [[nodiscard]] std::int32_t block(std::size_t index) const { return state_[index]; }
  /// Returns the array of the states (block()) of all blocks of the grid.
  [[nodiscard]] const std::int32_t* blocks() const { return state_.data(); }

  /// Bit mask of the cubes of a block with an exterior corner: one bit per cell, the first word for z = 0 and 1, the
  /// second for z = 2 and 3. The cube of a cell has its corners at the centres of the cell (x, y, z) and of its seven
  /// neighbours with coordinates up to (x + 1, y + 1, z + 1).
  using Cubes = std::array<std::uint32_t, 2>;
  /// Returns a pointer into an array that is indexed by the states of blocks, which may be negative: cubes()[block(i)]
  /// are the cubes of block i. There are none for none_exterior, and some for smaller states.
  [[nodiscard]] const Cubes* cubes() const { return cubes_.data() + first_cubes_; }

  /// Returns the bit mask of the exterior cells of a block, given its index in the grid.
  [[nodiscard]] std::uint64_t exterior_cells(std::size_t index) const {
    const std::int32_t state = state_[index];
    if (state < 0) return state == all_exterior ? ~std::uint64_t{0} : 0;
    return boundary_cells(static_cast<std::size_t>(state));
  }

 private:
  /// Block near the surface that the flood fill reached, with the bit mask `seeds` of its cells adjacent to exterior
  /// cells.
  struct Reached {
    std::uint32_t block;
    std::uint64_t seeds;
  };

  class Flood;

  std::vector<Reached> flood_far_blocks(const std::vector<std::uint8_t>& near_surface);
  std::vector<BlockKind> classify(const std::vector<Reached>& blocks, double band, bool parallel);
  void classify_diagonal_neighbours(const std::vector<std::uint8_t>& near_surface, double band, bool parallel);
  void find_cubes(bool parallel);

  const BlockGrid& grid_;
  const GridSurface& surface_;
  std::vector<std::int32_t> state_;      ///< per block of the grid: value of block()
  std::vector<BoundaryBlock> boundary_;  ///< value of boundary()
  std::vector<std::uint64_t> exterior_;  ///< per block of boundary_: bit mask of the exterior cells
  std::vector<Cubes> cubes_;             ///< bit masks of the cubes of blocks, in the order of the states of the blocks
  std::ptrdiff_t first_cubes_ = 0;       ///< index in cubes_ of the cubes of state 0
};

}  // namespace shapegauge
