// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "shapegauge/core/fields/inscribed_ball.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/core/spatial/triangle_bvh.h"

/// Parts of faces where thickness or gap width is below a limit; not part of the public interface.
namespace shapegauge {

/// Triangular part of a face.
struct Cell {
  std::array<Eigen::Vector3d, 3> corners;  ///< positions of the three corners, in the shape's coordinates
  std::int32_t face = 0;                   ///< index of the face in the mesh
  std::int32_t origin = 0;  ///< index, among the cells passed to CellSampler::divide(), of the one that contains this
};

/// Returns the faces of a mesh as undivided cells, without degenerate and duplicate faces.
std::vector<Cell> cells_of(const Shape& mesh);

/// Cell where the thickness or gap width is below the limit, at least in part.
struct ThinCell {
  Cell cell;        ///< triangular part of a face
  double area = 0;  ///< area of the part of the cell where the thickness or width is below the limit
  std::array<std::optional<double>, 3> diameters;  ///< ball diameter near each corner; empty if not below the limit
  bool is_edge = false;                            ///< true at a sharp edge (ThinRegion::is_edge)
};

/// Result of CellSampler::divide(): cells that are below the limit at least in part, and the others.
struct DividedCells {
  std::vector<ThinCell> thin;  ///< cells where the thickness or width is below the limit, at least in part
  std::vector<Cell> others;    ///< cells where the thickness or width is nowhere below the limit

  /// Returns all cells, first those below the limit.
  [[nodiscard]] std::vector<Cell> all() const;
};

/// Ball with a diameter below the limit and the sampled point of the surface that it touches.
struct SampledBall {
  Eigen::Vector3d position;  ///< sampled point of the surface
  TouchingBall ball;         ///< ball that touches the surface at `position`
};

/// Finds the parts of a mesh's surface where wall thickness or gap width is below a limit.
class CellSampler {
 public:
  /// Maximum size of cells along the border of a region, as a fraction of the limit.
  static constexpr double border_size = 1.0 / 8;

  /// Prepares the sampling of balls on one side of the surface: inside for wall thickness, outside for gap width. Keeps
  /// references to mesh and balls.
  CellSampler(const Shape& mesh, const TouchingBalls& balls, BallSide side, double limit, bool parallel);

  /// Divides cells until those below the limit are smaller than spacing(), and than `border_size` times the limit along
  /// the borders of regions.
  [[nodiscard]] DividedCells divide(std::vector<Cell> cells) const;

  /// Returns the smallest ball found in a thin cell. Halves the cell repeatedly and continues in the half with the
  /// smaller ball.
  [[nodiscard]] SampledBall smallest_ball_in(const ThinCell& thin) const;

  [[nodiscard]] double limit() const { return limit_; }  ///< minimum thickness or width

  /// Returns the largest size of sampled cells: the limit, or more on a mesh of a very large area.
  [[nodiscard]] double spacing() const { return spacing_; }

 private:
  /// Result of examine() for a cell: whether to split it, or its ThinCell if it is below the limit.
  struct Finding {
    bool split = false;                 ///< true if the cell must be split
    std::optional<ThinCell> thin = {};  ///< the cell if the thickness or width is below the limit; otherwise empty
  };

  [[nodiscard]] Finding examine(const Cell& cell) const;
  void mark_edges(std::vector<ThinCell>& cells) const;  ///< sets ThinCell::is_edge
  [[nodiscard]] bool opens_to_limit(const ThinCell& thin, const TriangleBVH& openings, const UnitFrame& frame) const;
  [[nodiscard]] Eigen::Vector3d ball_centre(const Cell& cell, std::size_t corner, double diameter) const;
  [[nodiscard]] std::optional<TouchingBall> ball_at(const Cell& cell, const Eigen::Vector3d& point) const;
  [[nodiscard]] double crossing(const Cell& cell, const Eigen::Vector3d& below, const Eigen::Vector3d& above) const;
  [[nodiscard]] double fraction_below(const ThinCell& thin) const;  ///< fraction of the cell's area below the limit

  const Shape& mesh_;
  const TouchingBalls& balls_;
  BallSide side_;   ///< inside for wall thickness, outside for gap width
  double limit_;    ///< value of limit()
  bool parallel_;   ///< true to use the threads of the calling TBB arena
  double spacing_;  ///< value of spacing()
};

}  // namespace shapegauge
