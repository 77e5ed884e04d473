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

/// Number of extra entries at the end of padded arrays, so that whole SIMD vectors of up to 16 floats can be read.
inline constexpr std::size_t grid_padding = 16;

/// Array aligned to cache lines of 64 bytes: a SIMD vector inside an aligned group of 16 floats never crosses one.
template <typename T>
using AlignedArray = std::vector<T, boost::alignment::aligned_allocator<T, 64>>;

/// Bounding boxes, in cells, of groups of consecutive points: group i extends from low[k][i] to high[k][i] along axis
/// k. Padded by grid_padding entries.
struct PointBoxes {
  /// Number of consecutive points of a group. The index of the first point of group i is i * group_size.
  static constexpr std::size_t group_size = grid_padding;
  std::array<AlignedArray<float>, 3> low, high;  ///< lowest and highest corners of the boxes: [axis][group], in cells
};

/// Points sampled on triangles, sorted by block of a grid, and within a block along a Morton curve.
struct GridPoints {
  AlignedArray<float> x, y, z;  ///< coordinates of the points, in cells; padded by infinity
  AlignedArray<float> area;     ///< surface area represented by each point, in squared cells; padded by grid_padding
  std::vector<std::int32_t> triangle;  ///< index of the triangle that contains each point; padded by grid_padding
  std::vector<std::uint32_t> first;    ///< per block: index of its first point; last entry: number of points
  PointBoxes boxes;                    ///< bounding boxes of groups of points

  [[nodiscard]] std::size_t size() const { return first.empty() ? 0 : first.back(); }

  /// Range of point indices from begin to before end.
  struct Run {
    std::uint32_t begin, end;
  };
  /// Finds the index ranges of the points in all blocks within `reach` of a position along each axis, in cells. Each
  /// range is in one row of blocks along x. The runs are ascending and not empty.
  void find_runs(const BlockGrid& grid, const Eigen::Vector3d& position, double reach, std::vector<Run>& runs) const;
};

/// Surface in cell coordinates: its triangles (degenerate ones for the points of a cloud), and points sampled on them
/// at most `spacing` apart, which give the closest triangle quickly.
///
/// Triangles much smaller than a cube of edge r/16 are represented by one triangle per cube, which limits the cost of
/// fine meshes. An omitted triangle is at most the diagonal of the cube away from its representative; at a distance of
/// r this is an error of less than 0.006 r.
struct GridSurface {
  TriangleTable triangles;  ///< all triangles of the shape, in cell coordinates
  GridPoints points;        ///< points sampled on the triangles that are not omitted
  /// Points on the omitted triangles, which other triangles represent. Used only to test whether samples lie on the
  /// surface.
  GridPoints omitted;
  double spacing;  ///< maximum spacing of the points on a triangle, in cells
  /// Bound for the search of the triangle closest to a position, in squared cells: the squared distance of one of this
  /// triangle's points exceeds that of the nearest point by at most this. 0 if most triangles have one point.
  double squared_margin = 0;
  double points_per_block = 0;  ///< mean number of points in blocks with points

  /// Samples points on the triangles of the shape, at most `max_spacing` cells apart.
  GridSurface(const BlockGrid& grid, const Shape& shape, double max_spacing, bool parallel);
};

/// Returns a triangle of the shape in cell coordinates.
Triangle triangle_in_cells(const BlockGrid& grid, const Shape& shape, Eigen::Index triangle);

/// Measures of a surface that bound the number of points sampled on it, in the shape's units.
struct SurfaceExtent {
  explicit SurfaceExtent(const Shape& shape);

  double pieces = 0;   ///< number of triangles of a mesh, or of points of a cloud
  double lengths = 0;  ///< sum of the lengths of the triangles' longest edges
  double area = 0;     ///< area of the surface

  /// Returns an upper bound of the number of points that a GridSurface samples at a spacing, in the shape's units.
  [[nodiscard]] double max_points(double spacing) const {
    return pieces + 2 * lengths / spacing + area / (spacing * spacing);
  }
};

}  // namespace shapegauge
