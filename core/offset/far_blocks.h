// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "shapegauge/core/offset/block_cells.h"
#include "shapegauge/core/offset/block_grid.h"

namespace shapegauge {

/// Set of blocks: a bit for each, in rows along x.
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

/// Blocks connected to the border of the grid through blocks that are not near the surface. Flood-filled a row at a
/// time; the row of a block along x has the index y + z * (number of blocks along y).
class FarBlocks {
 public:
  /// `near_surface` marks the blocks near the surface. The first block of the grid, at its border, is not one of them.
  FarBlocks(const BlockGrid& grid, const std::vector<std::uint8_t>& near_surface);

  [[nodiscard]] std::size_t size_x() const { return size_x_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }

  [[nodiscard]] bool contain(std::size_t row, std::size_t x) const {
    return (far_.row(row)[x / BlockRows::bits] >> (x % BlockRows::bits) & 1U) != 0;
  }

  /// Returns the cells of a block that touch far blocks.
  [[nodiscard]] BlockCells touching(std::size_t row, std::size_t x) const;

 private:
  /// Calls visit(row, cells) for each adjacent row, with the cells of a block of this row that touch it.
  template <typename Visit>
  void for_each_side(std::size_t row, const Visit& visit) const;
  void flood();
  /// Spreads a row to an adjacent one. Returns true if that one changed.
  bool spread_to_row(std::size_t row, std::size_t next);

  std::size_t size_x_;
  std::size_t size_y_;
  std::size_t rows_;
  BlockRows open_;
  BlockRows far_;
};

}  // namespace shapegauge
