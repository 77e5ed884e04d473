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

/// The boundary loops of a mesh. A boundary edge has one triangle; vertices at the same place are merged. Loops that
/// touch at a vertex are separated there. A path that does not close, as non-manifold edges can leave, is closed by
/// joining its ends. Orientation plays no part. None for a watertight mesh or a cloud. Throws InputError for an
/// unusable shape (require_usable()).
std::vector<BoundaryLoop> boundary_loops(const Shape& shape);

/// The radius of the largest circle inside a plane polygon (corners in order, either way round): never too large, and
/// too small by at most 1 % of itself plus 0.1 % of the diagonal of the polygon's bounding box. 0 for fewer than three
/// corners.
double inscribed_circle_radius(const std::vector<Eigen::Vector2d>& polygon);

/// The radius of the widest gap through which an offset surface leaks into a shape, in the shape's units; a larger
/// offset closes all gaps.
///
/// Of a mesh: the radius of the largest circle that fits into a hole, each hole being a boundary loop seen along its
/// vector area; holes wider than the limit do not count, so that the mouth of a vase need not pass for a gap. 0 for a
/// watertight mesh. Of a cloud, whatever the limit: the distance within which 999 of 1000 points have their sixth
/// neighbour (or their last, in smaller clouds); balls of that radius about random points leave hardly a hole. Holes in
/// a scan are not detected. Throws InputError for an unusable shape (require_usable()).
double gap_size(const Shape& shape, double limit = std::numeric_limits<double>::infinity());

/// The spacing of a cloud's points: the median distance to the sixth neighbour, on a regular surface about 1.4 times
/// the mean distance. 0 for a mesh. Throws InputError for an unusable shape (require_usable()).
double point_spacing(const Shape& shape);

}  // namespace shapegauge
