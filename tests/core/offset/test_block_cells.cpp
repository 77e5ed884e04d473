// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <gtest/gtest.h>
#include <random>
#include <vector>

#include "shapegauge/core/offset/block_cells.h"
#include "shapegauge/core/offset/block_grid.h"

namespace shapegauge {
namespace {

bool has_cell(BlockCells cells, const Eigen::Vector3i& at) {
  const int bit = at.x() + block_edge * (at.y() + block_edge * at.z());
  return (cells >> bit & 1U) != 0;
}

bool is_inside(const Eigen::Vector3i& at) { return (at.array() >= 0).all() && (at.array() < block_edge).all(); }

template <typename Condition>
BlockCells cells_where(Condition condition) {
  BlockCells cells = 0;
  for (int bit = 0; bit < cells_per_block; ++bit) {
    const Eigen::Vector3i at(bit % block_edge, bit / block_edge % block_edge, bit / (block_edge * block_edge));
    if (condition(at)) cells |= BlockCells{1} << bit;
  }
  return cells;
}

std::vector<Eigen::Vector3i> sides() { return {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}; }

/// Adds free cells that share a face with a filled one, until there are none.
BlockCells filled_cell_by_cell(BlockCells cells, BlockCells free) {
  cells &= free;
  while (true) {
    const BlockCells wider = cells_where([&](const Eigen::Vector3i& at) {
      if (has_cell(cells, at)) return true;
      for (const Eigen::Vector3i& side : sides()) {
        if (has_cell(free, at) && is_inside(at + side) && has_cell(cells, at + side)) return true;
      }
      return false;
    });
    if (wider == cells) return cells;
    cells = wider;
  }
}

TEST(BlockCells, FloodFillSpreadsAcrossFacesOfCells) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 500; ++i) {
    const BlockCells seeds = BlockCells{1} << (random() % cells_per_block);
    const BlockCells half = random();
    const BlockCells free = half | random();
    EXPECT_EQ(flood_fill(seeds, free), filled_cell_by_cell(seeds, free));
  }
}

TEST(BlockCells, CellsAcrossASideShareAFaceWithTheGivenCells) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 100; ++i) {
    const BlockCells cells = random();
    for (int side = 0; side < 6; ++side) {
      const Eigen::Vector3i step = sides()[static_cast<std::size_t>(side)];
      // A cell of the neighbour, seen from the block, is one step beyond the block's side.
      EXPECT_EQ(cells_across(cells, side), cells_where([&](const Eigen::Vector3i& at) {
                  const Eigen::Vector3i local = at + block_edge * step - step;
                  return is_inside(local) && has_cell(cells, local);
                }))
          << "side " << side;
    }
  }
}

TEST(BlockCells, CellsTouchingANeighbourLieAtTheSharedSideEdgeOrCorner) {
  for (int i = 0; i < 27; ++i) {
    const Eigen::Vector3i direction(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    // A cell touches the neighbour if a step in that direction leaves the block along every axis of the direction.
    EXPECT_EQ(cells_touching(direction), cells_where([&](const Eigen::Vector3i& at) {
                const Eigen::Vector3i beyond = at + direction;
                for (Eigen::Index k = 0; k < 3; ++k) {
                  if (direction[k] != 0 && beyond[k] >= 0 && beyond[k] < block_edge) return false;
                }
                return true;
              }))
        << direction.transpose();
  }
}

}  // namespace
}  // namespace shapegauge
