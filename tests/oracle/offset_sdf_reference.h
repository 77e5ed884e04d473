// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/core/spatial/closest_point.h"

namespace shapegauge {

/// The definition of the offset SDF taken literally (docs/reference/definitions.md#offset-sdf): every distance is a
/// minimum over all triangles, the exterior is a dense grid flooded from outside, the ray is followed in small steps.
/// Slow and simple: the specification of the fast implementation.
class OffsetSdfReference {
 public:
  /// r is a length in the shape's units.
  OffsetSdfReference(const Shape& shape, double r);

  /// d(x). Triangles whose bounding ball is farther than one before are skipped.
  [[nodiscard]] double distance(const Eigen::Vector3d& x) const;

  /// Whether x lies in E(r), for a smaller or larger r by the factor; passages that the grid does not resolve are
  /// closed.
  [[nodiscard]] bool is_exterior(const Eigen::Vector3d& x, double factor = 1) const;

  /// Whether the free space at x is wide enough for the grid to tell what it is connected to: somewhere near x a ball
  /// fits in that holds all of a cell.
  [[nodiscard]] bool is_resolved(const Eigen::Vector3d& x) const;

  /// Distance from p to the closest exterior point, to within 0.004 r.
  [[nodiscard]] double distance_to_exterior(const Eigen::Vector3d& p) const;

  /// |p'q|: the distance to the closest exterior point from p as raised on either side, whichever is less.
  [[nodiscard]] double distance_from_raised(const std::array<Eigen::Vector3d, 2>& raised) const;

  /// Distance along the ray to the first point that is exterior for an offset of r * factor, in steps of r / 500.
  [[nodiscard]] double exit(const Eigen::Vector3d& p, const Eigen::Vector3d& direction, double factor) const;

 private:
  /// A triangle and a ball about it.
  struct BoundedTriangle {
    Triangle triangle;
    Eigen::Vector3d centre;
    double radius;
  };

  [[nodiscard]] Eigen::Vector3i cell_of(const Eigen::Vector3d& x) const;
  [[nodiscard]] Eigen::Vector3d centre_of(const Eigen::Vector3i& cell) const;
  [[nodiscard]] bool is_in_grid(const Eigen::Vector3i& cell) const;
  [[nodiscard]] std::size_t index_of(const Eigen::Vector3i& cell) const;
  [[nodiscard]] bool grid_is_exterior_within(const Eigen::Vector3d& x, double distance) const;
  void flood();

  std::vector<BoundedTriangle> triangles_;
  double r_;
  double spacing_;
  Eigen::Vector3d low_;
  Eigen::Vector3i size_;
  std::vector<char> exterior_;
};

}  // namespace shapegauge
