#pragma once

#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// A closed path of boundary edges: the rim of a hole, or of an open surface.
struct BoundaryLoop {
  std::vector<std::int32_t> vertices;                     ///< in order; the last is joined to the first
  double length = 0;                                      ///< in the shape's units
  Eigen::Vector3d vector_area = Eigen::Vector3d::Zero();  ///< its length is the area where the loop is plane
  /// 2 |vector area| / length: the radius of a round hole, the width of a long slit; no circle inside is larger.
  double radius_bound = 0;
};

/// The loops of a mesh's boundary edges: those that belong to one triangle, vertices at the same place taken as one.
/// Loops that touch at a vertex part there. A path that does not come back, as non-manifold edges can leave, is closed
/// by its ends. Orientation plays no part. None for a closed mesh or a cloud.
std::vector<BoundaryLoop> boundary_loops(const Shape& shape);

}  // namespace shapegauge
