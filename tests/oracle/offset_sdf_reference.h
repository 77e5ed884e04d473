// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/core/spatial/closest_point.h"

namespace shapegauge {

/// Reference implementation of the offset SDF, directly from its definition (docs/reference/definitions.md#offset-sdf).
/// Every distance is a minimum over all triangles, the exterior is a dense grid flooded from outside, and rays are
/// followed in small steps. Slow and simple: the specification of the fast implementation.
class OffsetSdfReference {
 public:
  /// Prepares the grid of a shape for the offset r, a length in the shape's units.
  OffsetSdfReference(const Shape& shape, double r);

  /// Returns d(x), the distance from x to the closest triangle, in the shape's units.
  [[nodiscard]] double distance(const Eigen::Vector3d& x) const;

  /// Returns true if x is exterior: connected to the outside by points at least r from the surface, and itself at least
  /// r * factor from the surface. Passages that the grid does not resolve count as closed.
  [[nodiscard]] bool is_exterior(const Eigen::Vector3d& x, double factor = 1) const;

  /// Returns true if the grid resolves the space at x: near x a cell lies completely farther than r from the surface.
  /// Otherwise is_exterior(x) may be wrong.
  [[nodiscard]] bool is_resolved(const Eigen::Vector3d& x) const;

  /// Returns the distance from p to the closest exterior point, to within 0.004 r.
  [[nodiscard]] double distance_to_exterior(const Eigen::Vector3d& p) const;

  /// Returns the smaller distance to the closest exterior point from the two raised points of a sample, one on either
  /// side of the surface (RaisedSamples).
  [[nodiscard]] double distance_from_raised(const std::array<Eigen::Vector3d, 2>& raised) const;

  /// Returns the distance along the ray from p in a unit direction to the first point with is_exterior(point, factor),
  /// in steps of r / 500.
  [[nodiscard]] double exit(const Eigen::Vector3d& p, const Eigen::Vector3d& direction, double factor) const;

 private:
  /// Triangle and its bounding ball.
  struct BoundedTriangle {
    Triangle triangle;
    Eigen::Vector3d centre;
    double radius;
  };

  [[nodiscard]] Eigen::Vector3i cell_of(const Eigen::Vector3d& x) const;  ///< grid cell that contains x
  [[nodiscard]] Eigen::Vector3d centre_of(const Eigen::Vector3i& cell) const;
  [[nodiscard]] bool is_in_grid(const Eigen::Vector3i& cell) const;
  [[nodiscard]] std::size_t index_of(const Eigen::Vector3i& cell) const;  ///< index of the cell in `exterior_`
  /// Returns true if an exterior cell, or space outside the grid, is within a distance of x, rounded up to cells.
  [[nodiscard]] bool grid_is_exterior_within(const Eigen::Vector3d& x, double distance) const;
  void flood();  ///< marks the exterior cells, from a corner of the grid

  std::vector<BoundedTriangle> triangles_;
  double r_;                    ///< offset
  double spacing_;              ///< edge length of a grid cell
  Eigen::Vector3d low_;         ///< minimum corner of the grid
  Eigen::Vector3i size_;        ///< number of cells along each axis
  std::vector<char> exterior_;  ///< per cell: 1 if exterior, otherwise 0
};

}  // namespace shapegauge
