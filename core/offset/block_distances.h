#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "shapegauge/core/offset/grid_surface.h"

namespace shapegauge {

/// Points near a block, with scratch buffers.
struct NearbyPoints {
  std::vector<float> x, y, z, squared;
  std::vector<std::int32_t> triangle;
  std::vector<std::uint32_t> index;
  std::vector<GridPoints::Run> runs;
};

/// The nearest of a set of points, by ascending distance, with scratch buffers.
struct NearestPoints {
  static constexpr std::size_t capacity = TriangleTable::batch_size;
  struct Candidate {
    float squared;
    std::int32_t triangle;
  };
  std::array<Candidate, capacity> list;
  std::size_t count = 0;
  std::vector<float> squared;        ///< scratch: squared distances, by vector of points
  std::vector<std::uint32_t> first;  ///< scratch: first point of each vector

  void add(float distance2, std::int32_t triangle) {
    if (count == capacity && distance2 >= list.back().squared) return;
    std::size_t at = count < capacity ? count++ : capacity - 1;
    for (; at > 0 && list[at - 1].squared > distance2; --at) list[at] = list[at - 1];
    list[at] = {distance2, triangle};
  }
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

/// Search radius of closest_triangle_near(), in cells, about a point close to the closest triangle.
inline constexpr double closest_reach = 0.5;

/// Returns the triangle closest to x among those with points in the octants within `reach` of a place on the surface;
/// -1 if there is none. The result is approximate for triangles much smaller than the spacing of the points.
std::int32_t closest_triangle_near(const BlockGrid& grid, const GridSurface& surface, const Eigen::Vector3d& place,
                                   double reach, const Eigen::Vector3d& x);

/// Computes the squared distances from a position to n points, and returns the smallest. All arrays are padded.
float squared_distances(const float* x, const float* y, const float* z, std::size_t n, const Eigen::Vector3f& from,
                        float* squared);

/// Writes the indices of those of n numbers that do not exceed the limit, ascending, and returns their number. The
/// numbers are padded.
std::size_t indices_within(const float* numbers, std::size_t n, float limit, std::uint32_t* indices);

}  // namespace shapegauge
