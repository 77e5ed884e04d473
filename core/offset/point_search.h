// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "shapegauge/core/offset/grid_surface.h"

/// Search among the points of a surface.

namespace shapegauge {

/// Finds the indices of the points within a distance of x, ascending.
void find_points_within(const BlockGrid& grid, const GridPoints& points, const Eigen::Vector3d& x, double distance,
                        std::vector<std::uint32_t>& indices);

/// Sixteen points, in adjacent cache lines.
struct alignas(64) PointBlock {
  std::array<float, grid_padding> x, y, z;  ///< infinite where there is no point
  std::array<std::int32_t, grid_padding> triangle;
};

/// Points in separate arrays, with room for more.
struct CollectedPoints {
  std::vector<float> x, y, z;
  std::vector<std::int32_t> triangle;
};

/// Searches for the closest triangles near positions on a surface. The space is divided into regions, which are cubes;
/// the points about the region of a position are collected when it is first needed. Used by one thread.
class ClosestTriangles {
 public:
  ClosestTriangles(const BlockGrid& grid, const GridSurface& surface);

  /// Returns the triangle closest to x among those with points within `reach` of the region of a position; -1 if there
  /// is none. The result depends on the position and x only. It is approximate for triangles much smaller than the
  /// spacing of the points.
  std::int32_t closest_near(const Eigen::Vector3d& position, const Eigen::Vector3d& x);

  /// Returns the triangle closest to x among those with points within a distance of x along each axis; -1 if there is
  /// none.
  std::int32_t closest_within(double distance, const Eigen::Vector3d& x);

  /// Margin around regions along each axis, in cells.
  static constexpr double reach = 0.75;
  /// Returns the edge of regions, in cells.
  [[nodiscard]] double region_edge() const { return edge_; }
  /// Returns the distance, in cells, from the lowest corner of the first region to the grid's along each axis.
  [[nodiscard]] double region_shift() const { return shift_; }

 private:
  struct Region {
    Eigen::Vector3i position = Eigen::Vector3i::Constant(-1);
    std::vector<PointBlock> points;
  };

  void collect(const Eigen::Vector3d& centre, double half_edge, std::vector<PointBlock>& points);
  [[nodiscard]] std::int32_t closest_of(const std::vector<PointBlock>& points, const Eigen::Vector3d& x);

  const BlockGrid& grid_;
  const GridSurface& surface_;
  double edge_;
  double shift_;  ///< large regions overlap fewer blocks if they are centred at the blocks' corners
  /// Regions, by the lowest bits of their coordinates: a cache without conflicts between neighbours.
  static constexpr unsigned bits_per_axis = 3;
  std::array<Region, std::size_t{1} << (3 * bits_per_axis)> regions_;
  std::vector<PointBlock> points_within_;  ///< scratch
  CollectedPoints collected_;              ///< scratch
  std::vector<std::int32_t> candidates_;   ///< scratch: triangles
  std::vector<GridPoints::Run> runs_;      ///< scratch
};

}  // namespace shapegauge
