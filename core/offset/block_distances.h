#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "shapegauge/core/offset/grid_surface.h"

namespace shapegauge {

/// Which points are near; kept from block to block so as not to allocate anew.
struct NearbyPoints {
  std::vector<float> x, y, z, squared;
  std::vector<std::int32_t> triangle;
  std::vector<std::uint32_t> index;
  std::vector<GridPoints::Run> runs;
};

/// The nearest points of a few, sorted, and room to find them in.
struct NearestPoints {
  static constexpr std::size_t most = TriangleTable::at_once;
  struct Candidate {
    float squared;
    std::int32_t triangle;
  };
  std::array<Candidate, most> list;
  std::size_t count = 0;
  std::vector<float> squared;        ///< of vectors of points
  std::vector<std::uint32_t> first;  ///< of each vector's points

  void add(float distance2, std::int32_t triangle) {
    if (count == most && distance2 >= list.back().squared) return;
    std::size_t at = count < most ? count++ : most - 1;
    for (; at > 0 && list[at - 1].squared > distance2; --at) list[at] = list[at - 1];
    list[at] = {distance2, triangle};
  }
};

/// Rows of blocks, as seen from one in their middle, that hold all points within a distance of its cells.
struct BlockSurroundings {
  struct Row {
    int j, k;   ///< along y and z
    int along;  ///< so many blocks to each side
  };
  double distance;
  std::vector<Row> rows;

  explicit BlockSurroundings(double within);
};

/// Looks at the distances of the centres of a block's cells to the surface's points, of which only those in the rows
/// around the block matter: they reach as far as r + band. Where they are mixed, fills in which are free, and the
/// triangle nearest to each.
BlockKind look_at_block(const BlockGrid& grid, const GridSurface& surface, std::uint32_t block,
                        const BlockSurroundings& around, NearbyPoints& nearby, BoundaryBlock& found);

/// How far, in cells, the closest triangle's points are looked for around a place near it.
inline constexpr double closest_reach = 0.5;

/// The triangle closest to x of those with points in the octants within reach of a place on the surface; -1 where there
/// is none. Of triangles much smaller than the points' spacing, one that is hardly farther.
std::int32_t closest_triangle_about(const BlockGrid& grid, const GridSurface& surface, const Eigen::Vector3d& place,
                                    double reach, const Eigen::Vector3d& x);

/// The smallest squared distance from x to the n points, and how far away each is. Both are padded.
float squared_distances(const float* x, const float* y, const float* z, std::size_t n, const Eigen::Vector3f& from,
                        float* squared);

/// The places of the n numbers that do not exceed the limit, in their order; returns how many. The numbers are padded.
std::size_t indices_within(const float* numbers, std::size_t n, float limit, std::uint32_t* indices);

}  // namespace shapegauge
