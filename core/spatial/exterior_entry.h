#pragma once

#include <Eigen/Core>

#include "shapegauge/core/spatial/offset_exterior.h"

namespace shapegauge {

/// Where a ray enters the exterior.
struct ExteriorEntry {
  double distance = 0;  ///< from the ray's origin
  bool decided = true;  ///< false where its belonging to the exterior could not be decided and was assumed
};

/// The first point at which a ray from a point of the surface enters the exterior E(r) (the design, section 2.2, step
/// 2). The first stretch of length r is in the offset solid, as the surface is. From there the search walks from cube
/// to cube of the octree, and in cubes that may hold exterior points from the end of one rounded triangle to the next.
/// The direction has length 1.
ExteriorEntry first_exterior_entry(const OffsetExterior& exterior, const Eigen::Vector3d& origin,
                                   const Eigen::Vector3d& direction);

}  // namespace shapegauge
