// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <gtest/gtest.h>
#include <random>
#include <vector>

#include "shapegauge/core/offset/far_blocks.h"

namespace shapegauge {
namespace {

/// Grid with more blocks along x than a word of a row has bits.
BlockGrid long_grid() { return {Eigen::AlignedBox3d(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(300, 20, 12)), 4, 1}; }

std::vector<Eigen::Vector3i> adjacent_blocks(const BlockGrid& grid, std::size_t index) {
  std::vector<Eigen::Vector3i> blocks;
  for (int side = 0; side < 6; ++side) {
    Eigen::Vector3i block = grid.block_at(index);
    block[side / 2] += side % 2 == 0 ? -1 : 1;
    if (grid.has_block(block)) blocks.push_back(block);
  }
  return blocks;
}

/// Breadth-first search from the first block.
std::vector<bool> reached_blocks(const BlockGrid& grid, const std::vector<std::uint8_t>& near_surface) {
  std::vector<bool> reached(grid.block_count());
  reached[0] = true;
  std::vector<std::size_t> queue{0};
  for (std::size_t next = 0; next < queue.size(); ++next) {
    for (const Eigen::Vector3i& block : adjacent_blocks(grid, queue[next])) {
      const std::size_t index = grid.block_index(block);
      if (reached[index] || near_surface[index] != 0) continue;
      reached[index] = true;
      queue.push_back(index);
    }
  }
  return reached;
}

std::vector<std::uint8_t> random_blocks(const BlockGrid& grid, unsigned seed, double share) {
  std::mt19937_64 random(seed);
  std::vector<std::uint8_t> marked(grid.block_count());
  for (std::uint8_t& mark : marked) mark = static_cast<double>(random() % 1000) < 1000 * share ? 1 : 0;
  marked[0] = 0;
  return marked;
}

TEST(FarBlocks, AreThoseReachedByBreadthFirstSearchAwayFromTheSurface) {
  const BlockGrid grid = long_grid();
  ASSERT_GT(grid.blocks.x(), BlockRows::bits);
  for (unsigned seed = 0; seed < 30; ++seed) {
    // About a third is where the open blocks of a cubic lattice just connect: paths are long and winding.
    const std::vector<std::uint8_t> near_surface = random_blocks(grid, seed, 0.4 + 0.01 * seed);
    const FarBlocks far(grid, near_surface);
    const std::vector<bool> reached = reached_blocks(grid, near_surface);
    for (std::size_t i = 0; i < reached.size(); ++i) {
      ASSERT_EQ(far.contain(i / far.size_x(), i % far.size_x()), reached[i]) << "seed " << seed << ", block " << i;
    }
  }
}

TEST(FarBlocks, MarkTheCellsOfABlockThatTouchFarBlocks) {
  const BlockGrid grid = long_grid();
  const std::vector<std::uint8_t> near_surface = random_blocks(grid, 1, 0.5);
  const FarBlocks far(grid, near_surface);
  for (std::size_t i = 0; i < near_surface.size(); ++i) {
    BlockCells expected = 0;
    for (const Eigen::Vector3i& block : adjacent_blocks(grid, i)) {
      const std::size_t next = grid.block_index(block);
      if (far.contain(next / far.size_x(), next % far.size_x())) {
        expected |= cells_touching(block - grid.block_at(i));
      }
    }
    ASSERT_EQ(far.touching(i / far.size_x(), i % far.size_x()), expected) << "block " << i;
  }
}

}  // namespace
}  // namespace shapegauge
