// SPDX-License-Identifier: GPL-3.0-or-later
// Symbols: r offset distance, band margin of ExteriorGrid.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "shapegauge/core/offset/grid_surface.h"

namespace shapegauge {

/// Scratch buffers of classify_block(): surface points near a block. The arrays may be longer than needed.
struct NearbyPoints {
  std::vector<GridPoints::Run> runs;  ///< index ranges of the points in the neighbourhood of the block
  std::vector<float> squared;         ///< squared distance of each point of `runs` from the block's centre
  std::size_t nearest = 0;    ///< index in GridPoints of the point nearest to the block's centre, if there is any
  float nearest_squared = 0;  ///< squared distance of the point `nearest` from the block's centre; infinite for none
  /// Coordinates, in cells, of the points that may be the nearest to the centre of one of the block's cells.
  std::vector<float> x, y, z;
  std::vector<std::int32_t> triangle;  ///< index of the triangle that contains each candidate point
  std::size_t count = 0;               ///< number of candidate points in x, y, z and triangle
};

/// Neighbourhood of a block: rows of blocks along x that contain all points within `distance` of its cells.
struct BlockNeighbourhood {
  struct Row {
    int j, k;   ///< offsets of the row from the central block along y and z, in blocks
    int along;  ///< number of blocks of the row on either side of the centre along x
  };
  double distance;        ///< radius of the neighbourhood, in cells
  std::vector<Row> rows;  ///< rows of blocks, by z and then y

  explicit BlockNeighbourhood(double within);  ///< neighbourhood of radius `within`, in cells
};

/// Classifies a block by the distances between its cells' centres and the surface points in its neighbourhood `around`,
/// whose radius is the offset distance plus `band` (ExteriorGrid), in cells. For a mixed block, writes the free cells
/// and the triangle nearest to each cell to `found`. `block` is its index in the grid; `nearby` is scratch.
BlockKind classify_block(const BlockGrid& grid, const GridSurface& surface, std::uint32_t block,
                         const BlockNeighbourhood& around, NearbyPoints& nearby, BoundaryBlock& found);

/// Writes the squared distances from the position `from` to the n points (x, y, z) to `squared`, and returns the
/// smallest; infinite if n is 0. All arrays are padded by grid_padding entries.
float squared_distances(const float* x, const float* y, const float* z, std::size_t n, const Eigen::Vector3f& from,
                        float* squared);

/// Writes the indices of all `numbers` that are at most `limit` to `indices`, ascending, and returns how many there
/// are. `numbers` has n entries and is padded by grid_padding more.
std::size_t indices_within(const float* numbers, std::size_t n, float limit, std::uint32_t* indices);

}  // namespace shapegauge
