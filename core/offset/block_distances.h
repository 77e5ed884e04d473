// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "shapegauge/core/offset/grid_surface.h"

namespace shapegauge {

/// Points near a block, in buffers that are reused. The arrays are at least as long as needed.
struct NearbyPoints {
  std::vector<GridPoints::Run> runs;  ///< the points of the neighbourhood
  std::vector<float> squared;         ///< distances of those points from the block's centre
  std::size_t nearest = 0;            ///< index of the point nearest to the centre, if there is any
  float nearest_squared = 0;          ///< its distance; infinite without points
  /// Points that may be the nearest to one of the block's cells, with their triangles.
  std::vector<float> x, y, z;
  std::vector<std::int32_t> triangle;
  std::size_t count = 0;
};

/// Rows of blocks around a central one that contain all points within a distance of its cells.
struct BlockNeighbourhood {
  struct Row {
    int j, k;   ///< offsets along y and z
    int along;  ///< number of blocks along x on either side
  };
  double distance;
  std::vector<Row> rows;

  explicit BlockNeighbourhood(double within);
};

/// Classifies a block by the distances between its cells' centres and the points in its neighbourhood, which
/// extends to r + band. For a mixed block, sets the free cells and the triangle nearest to each cell.
BlockKind classify_block(const BlockGrid& grid, const GridSurface& surface, std::uint32_t block,
                         const BlockNeighbourhood& around, NearbyPoints& nearby, BoundaryBlock& found);

/// Computes the squared distances from a position to n points, and returns the smallest. All arrays are padded.
float squared_distances(const float* x, const float* y, const float* z, std::size_t n, const Eigen::Vector3f& from,
                        float* squared);

/// Writes the indices of those of n numbers that do not exceed the limit, ascending, and returns their number. The
/// numbers are padded.
std::size_t indices_within(const float* numbers, std::size_t n, float limit, std::uint32_t* indices);

}  // namespace shapegauge
