#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// A closed path of boundary edges: the rim of a hole, or of an open surface.
struct BoundaryLoop {
  std::vector<std::int32_t> vertices;                     ///< in order; the last is joined to the first
  double length = 0;                                      ///< in the shape's units
  Eigen::Vector3d vector_area = Eigen::Vector3d::Zero();  ///< its length is the area where the loop is plane

  /// Of the circle of the same area: seen along the vector area, no circle inside of the loop is larger.
  [[nodiscard]] double radius_bound() const { return std::sqrt(vector_area.norm() / std::numbers::pi); }
};

/// The loops of a mesh's boundary edges: those that belong to one triangle, vertices at the same place taken as one.
/// Loops that touch at a vertex part there. A path that does not come back, as non-manifold edges can leave, is closed
/// by its ends. Orientation plays no part. None for a closed mesh or a cloud. Throws InputError where
/// the shape is unusable (validity.h).
std::vector<BoundaryLoop> boundary_loops(const Shape& shape);

/// The radius of the largest circle inside a polygon in the plane (corners in order, either way round): never too
/// large, and too small by at most a hundredth of itself and a thousandth of the diagonal of the polygon's box. 0 for
/// fewer than three corners.
double inscribed_circle_radius(const std::vector<Eigen::Vector2d>& polygon);

/// The radius of the gaps through which an offset surface leaks into a shape, in the shape's units; an r above it
/// closes them.
///
/// Of a mesh: the radius of the largest circle that fits into a hole, each hole being a boundary loop seen along its
/// vector area; holes wider than the limit do not count, so that the mouth of a vase need not pass for a gap. 0 for a
/// closed mesh. Of a cloud, whatever the limit: the distance within which 999 of 1000 points have their sixth
/// neighbour, or the last one where there are fewer; of points placed at random, the balls of that radius leave hardly
/// a hole. Holes in a scan are not seen. Throws InputError where the shape is unusable (validity.h).
double gap_size(const Shape& shape, double limit = std::numeric_limits<double>::infinity());

/// How far apart the points of a cloud are: the median distance to the sixth neighbour, on a regular surface about 1.4
/// times the mean distance. 0 for a mesh. Throws InputError where the shape is unusable (validity.h).
double point_spacing(const Shape& shape);

}  // namespace shapegauge
