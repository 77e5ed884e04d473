// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols: h edge of a cell, r offset distance, O(r) offset solid (points within r of the surface).
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
inline constexpr int cells_per_block = block_edge * block_edge * block_edge;  ///< number of cells of a block: 64

/// Grid of cubic cells around a shape, in blocks of 4 x 4 x 4. Points are in *cell coordinates*, in which cells are
/// unit cubes with integer corners. The offset distance r is 2.5 to 16 cells.
struct BlockGrid {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< corner of the grid, in the shape's coordinates
  double cell = 1;                                   ///< edge h of a cell, in the shape's units
  double r = 0;                                      ///< offset distance r, in cells
  Eigen::Vector3i blocks = Eigen::Vector3i::Zero();  ///< number of blocks along each axis

  /// Makes a grid of cells of edge h around a bounding box. The outermost blocks are farther from the box than the
  /// offset. Lengths are in the shape's units.
  BlockGrid(const Eigen::AlignedBox3d& bounds, double offset, double h);

  [[nodiscard]] Eigen::Vector3d to_cells(const Eigen::Vector3d& x) const { return (x - origin) / cell; }
  [[nodiscard]] std::size_t block_count() const;  ///< number of all blocks of the grid
  [[nodiscard]] bool has_block(const Eigen::Vector3i& block) const {
    return (block.array() >= 0).all() && (block.array() < blocks.array()).all();
  }
  /// Returns the index of a block, given its coordinates in blocks: x varies fastest, z slowest.
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
  /// Returns the coordinates of the block that contains the point x of the grid, in cells. Truncates, which is faster
  /// than rounding down: coordinates just below 0 give block 0.
  // NOLINTNEXTLINE(readability-convert-member-functions-to-static): reads like to_cells()
  [[nodiscard]] Eigen::Vector3i block_of(const Eigen::Vector3d& x) const { return (x / block_edge).cast<int>(); }
};

/// Block of 4 x 4 x 4 cells near the boundary of the offset solid O(r), the points within r of the surface.
struct BoundaryBlock {
  /// Bit mask of the cells whose centres are farther than the offset distance r from the surface.
  std::uint64_t free = 0;
  /// Per cell: index of the triangle closest to its centre, approximately. ExteriorGrid stores the bitwise complement
  /// of the index for exterior cells.
  std::array<std::int32_t, cells_per_block> nearest{};
  std::uint32_t index = 0;  ///< index of the block in the grid
};

/// Classification of a block by the distances of its cells' centres from the surface, in cells. `free`: all are larger
/// than the offset distance r plus `band` (ExteriorGrid). `covered`: all are smaller than r minus the diagonal of a
/// cell. `mixed`: all other blocks, and some that are nearly free or covered.
enum class BlockKind : std::uint8_t { free, covered, mixed };

/// Marks all blocks that are at most `reach` blocks away from a marked block along each axis. `marked` has one entry
/// per block: 0 or 1.
void dilate(const BlockGrid& grid, std::vector<std::uint8_t>& marked, int reach);

/// Marks each block (x, y, z) for which a block (x + i, y + j, z + k) with i, j and k of 0 or 1 is marked. `marked` has
/// one entry per block: 0 or 1.
void dilate_down(const BlockGrid& grid, std::vector<std::uint8_t>& marked);

}  // namespace shapegauge
