#pragma once

#include <Eigen/Core>

#include "shapegauge/core/offset/cells_around.h"

namespace shapegauge {

/// Returns the distance (in cells) along a ray with a unit direction, from a point of the surface to E(r), which is at
/// least r away.
double offset_exit(const ExteriorGrid& exterior, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction);

}  // namespace shapegauge
