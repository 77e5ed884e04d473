#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "shapegauge/core/offset/grid_surface.h"

namespace shapegauge {

/// The exterior E(r) of a shape, to the resolution of a grid: cells whose centres are farther than r from the surface
/// and that a way through such cells joins to the grid's border, from cell to cell across faces.
///
/// Two centres on different sides of a surface are at least 2r apart, and h is less than r: nothing leaks through a
/// wall. A passage is open where a chain of centres leads through it: always where its half-width exceeds r by
/// sqrt(3)/2 h, never where it is less than r - h^2 / 8r.
class ExteriorGrid {
 public:
  /// Cells within the band (in cells) above r have a nearest triangle.
  ExteriorGrid(const BlockGrid& grid, const GridSurface& surface, double band, bool parallel);

  [[nodiscard]] const BlockGrid& grid() const { return grid_; }
  [[nodiscard]] const GridSurface& surface() const { return surface_; }
  [[nodiscard]] const std::vector<BoundaryBlock>& boundary() const { return boundary_; }
  /// The exterior cells of one of the boundary().
  [[nodiscard]] std::uint64_t boundary_cells(std::size_t place) const { return exterior_[place]; }

  /// What a block is: all of its cells are exterior, none is, or it is among the boundary()'s.
  static constexpr std::int32_t all_exterior = -1;
  static constexpr std::int32_t none_exterior = -2;
  [[nodiscard]] std::int32_t block(std::size_t index) const { return state_[index]; }

  /// The block's cells that are exterior.
  [[nodiscard]] std::uint64_t exterior_cells(std::size_t index) const {
    const std::int32_t state = state_[index];
    if (state < 0) return state == all_exterior ? ~std::uint64_t{0} : 0;
    return boundary_cells(static_cast<std::size_t>(state));
  }

  /// Whether the block has exterior cells, or one that a step up along some of the axes leads to.
  [[nodiscard]] bool is_near_exterior(std::size_t index) const { return near_[index] != 0; }

 private:
  /// A block near the surface that the flood came to, and its cells that touch what is exterior.
  struct Reached {
    std::uint32_t block;
    std::uint64_t seeds;
  };

  class Flood;

  std::vector<Reached> flood_far_blocks(const std::vector<std::uint8_t>& near_surface);
  std::vector<BlockKind> look_at(const std::vector<Reached>& blocks, double band, bool parallel);
  void look_across_edges(const std::vector<std::uint8_t>& near_surface, double band, bool parallel);

  const BlockGrid& grid_;
  const GridSurface& surface_;
  std::vector<std::int32_t> state_;
  std::vector<std::uint8_t> near_;
  std::vector<BoundaryBlock> boundary_;
  std::vector<std::uint64_t> exterior_;  ///< the cells of each of the boundary_ that belong to E(r)
};

/// What is known of the surroundings of a point: of the eight cells whose centres are the corners of the cube, a cell
/// in size, that holds it.
struct CellsAround {
  std::array<std::int32_t, 8> triangles{};  ///< closest to a cell each; repeated where there are less
  int count = 0;                            ///< of the cells that have one
  bool touches_exterior = false;            ///< one of the eight is exterior
};
CellsAround cells_around(const ExteriorGrid& exterior, const Eigen::Vector3d& x);

/// From the closest points of the triangles around to x; false, and nothing, where none is known.
inline bool vectors_around(const ExteriorGrid& exterior, const CellsAround& around, const Eigen::Vector3d& x,
                           TriangleTable::Vectors& vectors) {
  if (around.count == 0) return false;
  exterior.surface().triangles.vectors_to(x, around.triangles.data(), vectors);
  return true;
}

}  // namespace shapegauge
