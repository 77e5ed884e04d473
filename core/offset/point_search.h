// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "shapegauge/core/offset/grid_surface.h"

/// Search among the points sampled on a surface (GridPoints).

namespace shapegauge {

/// Finds the indices of the points within `distance` of x, both in cells. Indices are ascending.
void find_points_within(const BlockGrid& grid, const GridPoints& points, const Eigen::Vector3d& x, double distance,
                        std::vector<std::uint32_t>& indices);

/// Coordinates and triangles of sixteen points, in adjacent cache lines.
struct alignas(64) PointBlock {
  std::array<float, grid_padding> x, y, z;          ///< coordinates in cells; infinite where there is no point
  std::array<std::int32_t, grid_padding> triangle;  ///< index of the triangle that contains each point
};

/// Scratch buffers of ClosestTriangles for collected points, in separate arrays that may be longer than needed.
struct CollectedPoints {
  std::vector<float> x, y, z;          ///< coordinates in cells
  std::vector<std::int32_t> triangle;  ///< index of the triangle that contains each point
};

/// Finds the triangle closest to a point, in cells, among the triangles near a given position. Space is divided into
/// cubic regions. The sampled points in and around a region are collected when the region is first needed, and reused
/// by later searches. Used by one thread.
class ClosestTriangles {
 public:
  ClosestTriangles(const BlockGrid& grid, const GridSurface& surface);

  /// Returns the index of the triangle closest to x among those with sampled points within `reach` of the region that
  /// contains `position`; -1 if there is none. The result depends on the position and x only. It is approximate for
  /// triangles much smaller than the spacing of the points.
  std::int32_t closest_near(const Eigen::Vector3d& position, const Eigen::Vector3d& x);

  /// Returns the index of the triangle closest to x among those with sampled points within `distance` of x along each
  /// axis; -1 if there is none.
  std::int32_t closest_within(double distance, const Eigen::Vector3d& x);

  /// Margin around a region, in cells along each axis, within which sampled points are collected.
  static constexpr double reach = 0.75;
  /// Returns the edge length of the cubic regions, in cells.
  [[nodiscard]] double region_edge() const { return edge_; }
  /// Returns the distance, in cells along each axis, from the lowest corner of the first region to the lowest corner of
  /// the grid.
  [[nodiscard]] double region_shift() const { return shift_; }

 private:
  /// Cubic region of space and the sampled points near it.
  struct Region {
    Eigen::Vector3i position = Eigen::Vector3i::Constant(-1);  ///< coordinates of the region, in regions; -1: none
    std::vector<PointBlock> points;                            ///< points collected in and around the region
  };

  void collect(const Eigen::Vector3d& centre, double half_edge, std::vector<PointBlock>& points);
  [[nodiscard]] std::int32_t closest_of(const std::vector<PointBlock>& points, const Eigen::Vector3d& x);

  const BlockGrid& grid_;
  const GridSurface& surface_;
  double edge_;  ///< edge length of the cubic regions, in cells
  /// Value of region_shift(), in cells: large regions overlap fewer blocks if they are centred at the corners of
  /// blocks.
  double shift_;
  /// Number of low bits of each coordinate that form the index of a region in the cache: neighbouring regions do not
  /// conflict.
  static constexpr unsigned bits_per_axis = 3;
  std::array<Region, std::size_t{1} << (3 * bits_per_axis)> regions_;
  std::vector<PointBlock> points_within_;  ///< scratch of closest_within()
  CollectedPoints collected_;              ///< scratch of collect()
  std::vector<std::int32_t> candidates_;   ///< scratch: indices of triangles
  std::vector<GridPoints::Run> runs_;      ///< scratch: index ranges of points
};

}  // namespace shapegauge
