#pragma once

#include <Eigen/Core>

#include "shapegauge/core/spatial/offset_exterior.h"

namespace shapegauge {

/// The middle of the directions, about a given one, in which the ball of radius r about a point p of the surface is
/// exposed: p + r u lies outside of the offset solid.
///
/// Every point of a cloud has a patch of the offset surface of its own, all of it as near to p as can be; only the
/// middle of the patch says which way the surface faces. The direction given must be one of them; what is returned is
/// one, too, and leads to the same part of the exterior. Directions up to 60 degrees away from the middle count.
Eigen::Vector3d middle_of_exposed(const OffsetExterior& exterior, const Eigen::Vector3d& p,
                                  const Eigen::Vector3d& direction);

}  // namespace shapegauge
