// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace shapegauge {

/// Number of cells of a block along each axis. The 64 cells are the bits of a word: bit x + 4 y + 16 z.
inline constexpr int block_edge = 4;
inline constexpr int cells_per_block = block_edge * block_edge * block_edge;

/// Grid of cubic cells around a shape, in blocks of 4 x 4 x 4. Points are in *cell coordinates*, in which cells are
/// unit cubes with integer corners. r is 2 to 8 cells.
struct BlockGrid {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< corner of the grid, in the shape's coordinates
  double cell = 1;                                   ///< edge h of a cell, in the shape's units
  double r = 0;                                      ///< offset, in cells
  Eigen::Vector3i blocks = Eigen::Vector3i::Zero();  ///< number along each axis

  /// Makes the grid for an offset and cells of edge h. The outermost blocks are farther than the offset from the box.
  BlockGrid(const Eigen::AlignedBox3d& bounds, double offset, double h);

  [[nodiscard]] Eigen::Vector3d to_cells(const Eigen::Vector3d& x) const { return (x - origin) / cell; }
  [[nodiscard]] std::size_t block_count() const;
  [[nodiscard]] bool has_block(const Eigen::Vector3i& block) const {
    return (block.array() >= 0).all() && (block.array() < blocks.array()).all();
  }
  [[nodiscard]] std::size_t block_index(const Eigen::Vector3i& block) const {
    return (static_cast<std::size_t>(block.z()) * static_cast<std::size_t>(blocks.y()) +
            static_cast<std::size_t>(block.y())) *
               static_cast<std::size_t>(blocks.x()) +
           static_cast<std::size_t>(block.x());
  }
  [[nodiscard]] Eigen::Vector3i block_at(std::size_t index) const {
    const auto x = static_cast<std::size_t>(blocks.x());
    const auto y = static_cast<std::size_t>(blocks.y());
    return {static_cast<int>(index % x), static_cast<int>(index / x % y), static_cast<int>(index / (x * y))};
  }
  /// Returns the block that contains a point of the grid. Truncates, which is faster than rounding down: coordinates
  /// just below 0 give block 0.
  // NOLINTNEXTLINE(readability-convert-member-functions-to-static): reads like to_cells()
  [[nodiscard]] Eigen::Vector3i block_of(const Eigen::Vector3d& x) const { return (x / block_edge).cast<int>(); }
};

/// Cells of a block near the boundary of the offset solid.
struct BoundaryBlock {
  std::uint64_t free = 0;  ///< bits of the cells whose centres lie outside O(r)
  /// By cell: triangle closest to its centre, approximately. ExteriorGrid stores the complement for exterior cells.
  std::array<std::int32_t, cells_per_block> nearest{};
  std::uint32_t index = 0;  ///< index of the block in the grid
};

/// Classification of a block. `free`: the centres of all cells are farther from the surface than r plus the band.
/// `covered`: they are nearer than r by more than a cell's diagonal. `mixed`: all other blocks.
enum class BlockKind : std::uint8_t { free, covered, mixed };

/// Marks all blocks within `reach` blocks of a marked one, along each axis.
void dilate(const BlockGrid& grid, std::vector<std::uint8_t>& marked, int reach);

/// Marks all blocks whose neighbour by one step up along any subset of the axes is marked.
void dilate_down(const BlockGrid& grid, std::vector<std::uint8_t>& marked);

}  // namespace shapegauge
