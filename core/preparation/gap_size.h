#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Closed path of boundary edges: the rim of a hole or of an open surface.
struct BoundaryLoop {
  std::vector<std::int32_t> vertices;                     ///< in order; the last is connected to the first
  double length = 0;                                      ///< in the shape's units
  Eigen::Vector3d vector_area = Eigen::Vector3d::Zero();  ///< its length is the enclosed area of a planar loop

  /// Returns the radius of the circle with the same area. No circle inside the loop, projected along the vector area,
  /// is larger.
  [[nodiscard]] double radius_bound() const { return std::sqrt(vector_area.norm() / std::numbers::pi); }
};

/// Extracts the boundary loops of a mesh with coincident vertices welded. A boundary edge has one triangle. Loops that
/// touch at a vertex are separated there. Open paths, which non-manifold edges can cause, are closed by joining their
/// ends. Independent of orientation. Empty for a closed mesh and for a cloud. Throws InputError for an unusable
/// shape (require_usable()).
std::vector<BoundaryLoop> boundary_loops(const Shape& shape);

/// Computes the radius of the largest circle inside a planar polygon, whose corners are in order in either direction.
/// Never too large; too small by at most 1 % of itself plus 0.1 % of the diagonal of the polygon's bounding box. 0 for
/// fewer than three corners.
double inscribed_circle_radius(const std::vector<Eigen::Vector2d>& polygon);

/// Radii of the widest gap of a shape and of the widest that is not wider than a limit, in the shape's units.
struct GapSizes {
  double widest = 0;
  double within_limit = 0;
};

/// Computes both sizes at once; gap_size() describes them.
GapSizes gap_sizes(const Shape& shape, double limit);

/// Computes the radius of the widest gap of a shape, in the shape's units. A larger offset closes all gaps.
///
/// For a mesh: the radius of the largest circle that fits into a hole; each hole is a boundary loop projected along its
/// vector area. Holes wider than `limit` are ignored: the mouth of a vase is not treated as a gap. 0 for a closed
/// mesh.
///
/// For a cloud, whatever the limit: the distance within which 999 of 1000 points have their sixth neighbour (or their
/// last, in smaller clouds). Balls of that radius about random points leave hardly a hole. Holes in a scan are not
/// detected.
///
/// Throws InputError for an unusable shape (require_usable()).
double gap_size(const Shape& shape, double limit = std::numeric_limits<double>::infinity());

/// Computes the point spacing of a cloud: the median distance to the sixth neighbour. On a regular surface it is about
/// 1.4 times the mean distance. 0 for a mesh. Throws InputError for an unusable shape (require_usable()).
double point_spacing(const Shape& shape);

}  // namespace shapegauge
