// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/offset/block_grid.h"

namespace shapegauge {
namespace {

/// A grid with the given numbers of blocks.
BlockGrid grid_of_blocks(const Eigen::Vector3i& blocks) {
  BlockGrid grid({Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()}, 0.2, 0.1);
  grid.blocks = blocks;
  return grid;
}

const std::vector<Eigen::Vector3i>& sizes_of_grids() {
  static const std::vector<Eigen::Vector3i> sizes{{1, 1, 1}, {4, 1, 1}, {1, 5, 1}, {1, 1, 3},
                                                  {2, 3, 1}, {1, 3, 4}, {5, 4, 6}};
  return sizes;
}

TEST(BlockGrid, OutermostBlocksLieBeyondTheOffset) {
  RandomNumbers random(1);
  for (int round = 0; round < 300; ++round) {
    const auto point = [&] {
      return Eigen::Vector3d{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(0, 1)};
    };
    Eigen::AlignedBox3d bounds(point());
    if (round % 3 != 0) bounds.extend(point());  // otherwise a single point
    const double offset = random.uniform(0.05, 2);
    const double h = offset / random.uniform(2, 8);
    const BlockGrid grid(bounds, offset, h);
    EXPECT_EQ(grid.cell, h);
    EXPECT_DOUBLE_EQ(grid.r * grid.cell, offset);
    // In the shape's units: the inner face of the outermost layer of blocks, on either side.
    const double block = block_edge * h;
    const Eigen::Vector3d low = grid.origin.array() + block;
    const Eigen::Vector3d high = grid.origin + block * (grid.blocks.cast<double>().array() - 1).matrix();
    EXPECT_GT((bounds.min() - low).minCoeff(), offset);
    EXPECT_GT((high - bounds.max()).minCoeff(), offset);
    EXPECT_LT((bounds.min() - grid.origin).maxCoeff(), offset + 2 * h + 2 * block) << "no more than needed";
  }
}

TEST(BlockGrid, IndicesOfBlocksRunAlongXFirst) {
  for (const Eigen::Vector3i& size : sizes_of_grids()) {
    const BlockGrid grid = grid_of_blocks(size);
    ASSERT_EQ(grid.block_count(), static_cast<std::size_t>(size.prod()));
    std::size_t index = 0;
    for (int z = 0; z < size.z(); ++z) {
      for (int y = 0; y < size.y(); ++y) {
        for (int x = 0; x < size.x(); ++x, ++index) {
          EXPECT_EQ(grid.block_index({x, y, z}), index);
          EXPECT_EQ(grid.block_at(index), Eigen::Vector3i(x, y, z));
          EXPECT_TRUE(grid.has_block({x, y, z}));
          EXPECT_EQ(grid.block_of(block_edge * Eigen::Vector3d(x + 0.01, y + 0.5, z + 0.99)), Eigen::Vector3i(x, y, z));
        }
      }
    }
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_FALSE(grid.has_block(-Eigen::Vector3i::Unit(axis)));
      EXPECT_FALSE(grid.has_block(size[axis] * Eigen::Vector3i::Unit(axis)));
    }
  }
}

/// A share of the blocks, drawn at random.
std::vector<std::uint8_t> random_marks(const BlockGrid& grid, double share, std::uint64_t seed) {
  RandomNumbers random(seed);
  std::vector<std::uint8_t> marked(grid.block_count());
  for (std::uint8_t& mark : marked) mark = random.uniform(0, 1) < share ? 1 : 0;
  return marked;
}

/// The blocks b for which a marked block c has low <= c - b <= high along each axis.
std::vector<std::uint8_t> marked_within(const BlockGrid& grid, const std::vector<std::uint8_t>& marked, int low,
                                        int high) {
  std::vector<std::uint8_t> result(marked.size(), 0);
  for (std::size_t b = 0; b < marked.size(); ++b) {
    for (std::size_t c = 0; c < marked.size(); ++c) {
      const Eigen::Array3i step = grid.block_at(c) - grid.block_at(b);
      if (marked[c] != 0 && (step >= low).all() && (step <= high).all()) result[b] = 1;
    }
  }
  return result;
}

TEST(DilatedBlocks, AreTheBlocksWithinReachOfMarkedBlocks) {
  for (const Eigen::Vector3i& size : sizes_of_grids()) {
    const BlockGrid grid = grid_of_blocks(size);
    for (int reach = 0; reach <= 3; ++reach) {
      for (std::uint64_t seed = 0; seed < 4; ++seed) {
        std::vector<std::uint8_t> marked = random_marks(grid, 0.02 + 0.1 * static_cast<double>(seed), seed);
        marked[seed % marked.size()] = 1;
        const std::vector<std::uint8_t> expected = marked_within(grid, marked, -reach, reach);
        dilate(grid, marked, reach);
        EXPECT_EQ(marked, expected) << size.transpose() << ", reach " << reach;
      }
    }
  }
}

TEST(DilateDown, MarksTheLowerNeighboursOfMarkedBlocks) {
  for (const Eigen::Vector3i& size : sizes_of_grids()) {
    const BlockGrid grid = grid_of_blocks(size);
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      std::vector<std::uint8_t> marked = random_marks(grid, 0.1, seed);
      marked[marked.size() - 1 - seed % marked.size()] = 1;
      const std::vector<std::uint8_t> expected = marked_within(grid, marked, 0, 1);
      dilate_down(grid, marked);
      EXPECT_EQ(marked, expected) << size.transpose();
    }
  }
}

}  // namespace
}  // namespace shapegauge
