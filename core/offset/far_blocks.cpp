// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/offset/far_blocks.h"

namespace shapegauge {

namespace {

/// Flood-fills the open bits of a word, in both directions.
BlockRows::Word spread(BlockRows::Word reached, BlockRows::Word open) {
  reached &= open;
  BlockRows::Word up = open;
  BlockRows::Word down = open;
  BlockRows::Word left = reached;
  BlockRows::Word right = reached;
  for (unsigned shift = 1; shift < BlockRows::bits; shift *= 2) {
    left |= up & (left << shift);
    up &= up << shift;
    right |= down & (right >> shift);
    down &= down >> shift;
  }
  return left | right;
}

/// Flood-fills the open bits of a row.
void spread_row(BlockRows::Word* reached, const BlockRows::Word* open, std::size_t words) {
  for (std::size_t i = 0; i < words; ++i) {
    if (i > 0) reached[i] |= reached[i - 1] >> (BlockRows::bits - 1);
    reached[i] = spread(reached[i], open[i]);
  }
  for (std::size_t i = words; i-- > 0;) {
    if (i + 1 < words) reached[i] |= reached[i + 1] << (BlockRows::bits - 1);
    reached[i] = spread(reached[i], open[i]);
  }
}

}  // namespace

FarBlocks::FarBlocks(const BlockGrid& grid, const std::vector<std::uint8_t>& near_surface)
    : size_x_(static_cast<std::size_t>(grid.blocks.x())),
      size_y_(static_cast<std::size_t>(grid.blocks.y())),
      rows_(near_surface.size() / size_x_),
      open_(grid),
      far_(grid) {
  for (std::size_t row = 0; row < rows_; ++row) {
    for (std::size_t x = 0; x < size_x_; ++x) {
      if (near_surface[row * size_x_ + x] == 0) open_.set(row, x);
    }
  }
  flood();
}

BlockCells FarBlocks::touching(std::size_t row, std::size_t x) const {
  BlockCells cells = 0;
  if (x > 0 && contain(row, x - 1)) cells |= low_x_cells;
  if (x + 1 < size_x_ && contain(row, x + 1)) cells |= high_x_cells;
  for_each_adjacent_row(row, [&](std::size_t next, BlockCells side) {
    if (contain(next, x)) cells |= side;
  });
  return cells;
}

template <typename Visit>
void FarBlocks::for_each_adjacent_row(std::size_t row, const Visit& visit) const {
  const std::size_t y = row % size_y_;
  if (y > 0) visit(row - 1, low_y_cells);
  if (y + 1 < size_y_) visit(row + 1, high_y_cells);
  if (row >= size_y_) visit(row - size_y_, low_z_cells);
  if (row + size_y_ < rows_) visit(row + size_y_, high_z_cells);
}

/// Flood-fills from the first block, which is at the border.
void FarBlocks::flood() {
  std::vector<std::size_t> waiting{0};
  far_.set(0, 0);
  spread_row(far_.row(0), open_.row(0), open_.words());
  while (!waiting.empty()) {
    const std::size_t row = waiting.back();
    waiting.pop_back();
    for_each_adjacent_row(row, [&](std::size_t next, BlockCells /*side*/) {
      if (spread_to_row(row, next)) waiting.push_back(next);
    });
  }
}

bool FarBlocks::spread_to_row(std::size_t row, std::size_t next) {
  bool is_new = false;
  for (std::size_t i = 0; i < open_.words(); ++i) {
    const BlockRows::Word added = far_.row(row)[i] & open_.row(next)[i] & ~far_.row(next)[i];
    far_.row(next)[i] |= added;
    is_new |= added != 0;
  }
  if (is_new) spread_row(far_.row(next), open_.row(next), open_.words());
  return is_new;
}

}  // namespace shapegauge
