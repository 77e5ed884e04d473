// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "shapegauge/core/offset/block_cells.h"
#include "shapegauge/core/offset/block_grid.h"

namespace shapegauge {

/// Set of blocks of a grid, stored as one bit per block, in rows along x.
class BlockRows {
 public:
  using Word = std::uint64_t;
  static constexpr int bits = 64;

  explicit BlockRows(const BlockGrid& grid)
      : words_((static_cast<std::size_t>(grid.blocks.x()) + bits - 1) / bits),
        rows_(words_ * static_cast<std::size_t>(grid.blocks.y()) * static_cast<std::size_t>(grid.blocks.z())) {}

  [[nodiscard]] std::size_t words() const { return words_; }
  [[nodiscard]] Word* row(std::size_t index) { return rows_.data() + index * words_; }
  [[nodiscard]] const Word* row(std::size_t index) const { return rows_.data() + index * words_; }

  void set(std::size_t row_index, std::size_t x) { row(row_index)[x / bits] |= Word{1} << (x % bits); }

 private:
  std::size_t words_;
  std::vector<Word> rows_;
};

/// Set of far blocks: blocks connected to the border of the grid through blocks that are not near the surface. It is
/// flood-filled row by row. The row of a block along x has the index y + z * (number of blocks along y).
class FarBlocks {
 public:
  /// Flood-fills the grid from its first block, at the border, which must not be near the surface. `near_surface` has
  /// one entry per block: non-zero near the surface.
  FarBlocks(const BlockGrid& grid, const std::vector<std::uint8_t>& near_surface);

  [[nodiscard]] std::size_t size_x() const { return size_x_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }

  [[nodiscard]] bool contain(std::size_t row, std::size_t x) const {
    return (far_.row(row)[x / BlockRows::bits] >> (x % BlockRows::bits) & 1U) != 0;
  }

  /// Returns the cells of the block at `x` in a row that share a face with a far block.
  [[nodiscard]] BlockCells touching(std::size_t row, std::size_t x) const;

 private:
  /// Calls visit(next, cells) for each row next to `row`, with the cells of a block of `row` that touch the row `next`.
  template <typename Visit>
  void for_each_side(std::size_t row, const Visit& visit) const;
  void flood();
  /// Spreads the far blocks of a row to the adjacent row `next`. Returns true if `next` has changed.
  bool spread_to_row(std::size_t row, std::size_t next);

  std::size_t size_x_;
  std::size_t size_y_;
  std::size_t rows_;
  BlockRows open_;
  BlockRows far_;
};

}  // namespace shapegauge
