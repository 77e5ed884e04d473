// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "shapegauge/core/offset/block_cells.h"
#include "shapegauge/core/offset/block_grid.h"

namespace shapegauge {

/// Set of blocks of a grid, stored as one bit per block, in rows along x. The row at (y, z) has the index
/// y + z * (number of blocks along y).
class BlockRows {
 public:
  using Word = std::uint64_t;      ///< bit set of 64 consecutive blocks of a row
  static constexpr int bits = 64;  ///< number of blocks in a Word

  explicit BlockRows(const BlockGrid& grid)
      : words_((static_cast<std::size_t>(grid.blocks.x()) + bits - 1) / bits),
        rows_(words_ * static_cast<std::size_t>(grid.blocks.y()) * static_cast<std::size_t>(grid.blocks.z())) {}

  [[nodiscard]] std::size_t words() const { return words_; }  ///< number of Words per row
  [[nodiscard]] Word* row(std::size_t index) { return rows_.data() + index * words_; }
  [[nodiscard]] const Word* row(std::size_t index) const { return rows_.data() + index * words_; }

  /// Adds block `x` of the row with the index `row_index` to the set.
  void set(std::size_t row_index, std::size_t x) { row(row_index)[x / bits] |= Word{1} << (x % bits); }

 private:
  std::size_t words_;       ///< number of Words per row
  std::vector<Word> rows_;  ///< Words of all rows, row by row
};

/// Far blocks of a grid: blocks that are not near the surface and are connected to the grid's border through such
/// blocks. All their cells are exterior. Found by a flood fill, row by row (BlockRows).
class FarBlocks {
 public:
  /// Flood-fills the grid from its first block, at the border, which must not be near the surface. `near_surface` has
  /// one entry per block: non-zero near the surface.
  FarBlocks(const BlockGrid& grid, const std::vector<std::uint8_t>& near_surface);

  [[nodiscard]] std::size_t size_x() const { return size_x_; }  ///< number of blocks of the grid along x
  [[nodiscard]] std::size_t rows() const { return rows_; }      ///< number of rows of blocks along x in the grid
  /// Returns true if block `x` of the row with the index `row` (BlockRows) is a far block.
  [[nodiscard]] bool contain(std::size_t row, std::size_t x) const {
    return (far_.row(row)[x / BlockRows::bits] >> (x % BlockRows::bits) & 1U) != 0;
  }

  /// Returns the cells of block `x` of the row with the index `row` (BlockRows) that share a face with a far block.
  [[nodiscard]] BlockCells touching(std::size_t row, std::size_t x) const;

 private:
  /// Calls visit(next, cells) for each row `next` adjacent to `row` along y or z. `cells` are the cells of a block on
  /// its side towards `next`.
  template <typename Visit>
  void for_each_adjacent_row(std::size_t row, const Visit& visit) const;
  void flood();
  /// Spreads the far blocks of a row to the adjacent row `next`. Returns true if this added blocks to `next`.
  bool spread_to_row(std::size_t row, std::size_t next);

  std::size_t size_x_;  ///< number of blocks of the grid along x
  std::size_t size_y_;  ///< number of blocks of the grid along y
  std::size_t rows_;    ///< number of rows of blocks along x in the grid
  BlockRows open_;      ///< blocks that are not near the surface
  BlockRows far_;       ///< far blocks found so far
};

}  // namespace shapegauge
