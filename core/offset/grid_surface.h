#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "shapegauge/core/offset/block_grid.h"
#include "shapegauge/core/offset/triangle_table.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/core/spatial/closest_point.h"

namespace shapegauge {

/// Padded arrays go on for so many more numbers: loops take as many at once.
inline constexpr std::size_t grid_padding = 16;

/// Points on triangles, sorted by the blocks of a grid, and within a block by its octants.
struct GridPoints {
  std::vector<float> x, y, z;          ///< in cells; padded
  std::vector<float> area;             ///< of the surface that each stands for; padded
  std::vector<std::int32_t> triangle;  ///< that each lies on
  std::vector<std::uint32_t> first;    ///< of each block's points, and one past the last's
  static constexpr int octant_edge = block_edge / 2;
  /// Of blocks that have points, the first of each octant's (bit x, y, z of its number) and one past the last's.
  std::vector<std::array<std::uint32_t, 9>> octants;
  std::vector<std::uint32_t> octants_of;  ///< by block: where they are; no_octants where it has no points
  static constexpr std::uint32_t no_octants = 0xFFFFFFFF;

  [[nodiscard]] bool empty() const { return triangle.empty(); }

  /// Points from begin to end.
  struct Run {
    std::uint32_t begin, end;
  };
  /// The points of all octants within reach of a place, along each axis.
  void find_runs(const BlockGrid& grid, const Eigen::Vector3d& place, double reach, std::vector<Run>& runs) const;
};

/// The surface in a grid: its triangles in cells (a cloud's points as triangles of no size), and points on them no
/// farther apart than a spacing, which say quickly which triangle is closest.
///
/// Of triangles so small that many are in a cube of edge r/16, one in each such cube stands for the others: the rest of
/// the grid costs no more than for a coarser surface. None is farther than the cube's diagonal from the one that
/// stands for it, and so at a distance of r nearer by less than 0.006 r.
struct GridSurface {
  TriangleTable triangles;
  GridPoints points;
  /// What others stand for: only samples are looked for on them.
  GridPoints left_out;
  double spacing;  ///< of the points, in cells
  /// How much farther, squared, than the nearest point one may be whose triangle is the closest: nothing where most
  /// triangles have one point.
  double hidden = 0;

  /// The points are so many cells apart.
  GridSurface(const BlockGrid& grid, const Shape& shape, double apart, bool parallel);
};

/// A triangle of the shape in cells.
Triangle triangle_in_cells(const BlockGrid& grid, const Shape& shape, Eigen::Index triangle);

/// How much surface there is, in the shape's unit.
struct SurfaceExtent {
  explicit SurfaceExtent(const Shape& shape);

  double pieces = 0;   ///< triangles or points
  double lengths = 0;  ///< of the triangles' longest edges
  double area = 0;

  /// No fewer than the points of a GridSurface of this spacing.
  [[nodiscard]] double most_points(double spacing) const {
    return pieces + 2 * lengths / spacing + area / (spacing * spacing);
  }
};

}  // namespace shapegauge
