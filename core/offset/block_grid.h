#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace shapegauge {

/// Cells of a block along each axis. A block's 64 cells are the bits of a word: bit x + 4 y + 16 z.
inline constexpr int block_edge = 4;
inline constexpr int cells_per_block = block_edge * block_edge * block_edge;

/// A grid of cubic cells around a shape, in blocks of 4 x 4 x 4. Points are given in *cells*: coordinates that count
/// cells from the grid's corner, so that cell (i, j, k) is [i, i + 1] x [j, j + 1] x [k, k + 1]. r is 2 to 8 in them.
struct BlockGrid {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< the corner, in the shape's coordinates
  double cell = 1;                                   ///< a cell's edge h, in the shape's coordinates
  double r = 0;                                      ///< the offset, in cells
  Eigen::Vector3i blocks = Eigen::Vector3i::Zero();  ///< along each axis

  /// The grid for an offset of r over cells of edge h; the outermost blocks hold no point within r of the box.
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
  /// The block around a point of the grid. Just below the grid it is 0 as well: to cut off is faster than to round.
  [[nodiscard]] Eigen::Vector3i block_of(const Eigen::Vector3d& x) const { return (x / block_edge).cast<int>(); }
};

/// The cells of a block near the boundary of the offset solid.
struct BoundaryBlock {
  std::uint64_t free = 0;                               ///< the cells whose centres lie outside of O(r)
  std::array<std::int32_t, cells_per_block> nearest{};  ///< the triangle closest to each cell's centre, about
  std::uint32_t index = 0;                              ///< the block's, in the grid
};

/// Whether the centres of a block's cells are all free and farther from the surface than the band, all covered and by
/// more than a cell's diagonal, or neither.
enum class BlockKind : std::uint8_t { free, covered, mixed };

/// Marks all blocks within so many blocks of a marked one, along each axis.
void dilate(const BlockGrid& grid, std::vector<std::uint8_t>& marked, int reach);

/// Marks all blocks from which one step up along some of the axes leads to a marked one.
void dilate_down(const BlockGrid& grid, std::vector<std::uint8_t>& marked);

}  // namespace shapegauge
