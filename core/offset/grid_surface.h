// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <boost/align/aligned_allocator.hpp>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "shapegauge/core/offset/block_grid.h"
#include "shapegauge/core/offset/triangle_table.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/core/spatial/closest_point.h"

namespace shapegauge {

/// Number of padding entries of padded arrays; no vector is wider.
inline constexpr std::size_t grid_padding = 16;

/// Array in whole cache lines, so that no vector of a group of sixteen numbers crosses one.
template <typename T>
using AlignedArray = std::vector<T, boost::alignment::aligned_allocator<T, 64>>;

/// Bounding boxes of groups of points, by axis and group. Padded.
struct PointBoxes {
  /// Number of consecutive points of a group. The first point of group i has the index i times this.
  static constexpr std::size_t group_size = grid_padding;
  std::array<AlignedArray<float>, 3> low, high;
};

/// Points on triangles, sorted by block of a grid, and within a block along a Morton curve.
struct GridPoints {
  AlignedArray<float> x, y, z;         ///< in cells; padded by infinite ones
  AlignedArray<float> area;            ///< area represented by each point; padded
  std::vector<std::int32_t> triangle;  ///< triangle that contains each point; padded
  std::vector<std::uint32_t> first;    ///< per block: index of its first point; one more entry at the end
  PointBoxes boxes;                    ///< of groups of points

  [[nodiscard]] std::size_t size() const { return first.empty() ? 0 : first.back(); }

  /// Range of points.
  struct Run {
    std::uint32_t begin, end;
  };
  /// Collects the points of all blocks within `reach` of a position along each axis. The runs are ascending and not
  /// empty.
  void find_runs(const BlockGrid& grid, const Eigen::Vector3d& position, double reach, std::vector<Run>& runs) const;
};

/// Surface in cell coordinates: its triangles (degenerate ones for the points of a cloud), and points sampled on them
/// at most `spacing` apart, which give the closest triangle quickly.
///
/// Triangles much smaller than a cube of edge r/16 are represented by one triangle per cube, which limits the cost of
/// fine meshes. An omitted triangle is at most the diagonal of the cube away from its representative; at a distance of
/// r this is an error of less than 0.006 r.
struct GridSurface {
  TriangleTable triangles;
  GridPoints points;
  /// Points of the omitted triangles, used only to locate samples.
  GridPoints omitted;
  double spacing;  ///< of the points, in cells
  /// Maximum difference of squared distances between the nearest point and the nearest point of the closest triangle; 0
  /// if most triangles have one point.
  double squared_margin = 0;
  double points_per_block = 0;  ///< mean number of points in blocks with points

  /// Samples points at a spacing of `apart` cells.
  GridSurface(const BlockGrid& grid, const Shape& shape, double apart, bool parallel);
};

/// Returns a triangle of the shape in cell coordinates.
Triangle triangle_in_cells(const BlockGrid& grid, const Shape& shape, Eigen::Index triangle);

/// Size of a surface, in the shape's units.
struct SurfaceExtent {
  explicit SurfaceExtent(const Shape& shape);

  double pieces = 0;   ///< number of triangles or points
  double lengths = 0;  ///< sum of the triangles' longest edges
  double area = 0;

  /// Returns an upper bound of the number of points of a GridSurface of this spacing.
  [[nodiscard]] double max_points(double spacing) const {
    return pieces + 2 * lengths / spacing + area / (spacing * spacing);
  }
};

}  // namespace shapegauge
