#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
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

}  // namespace shapegauge
