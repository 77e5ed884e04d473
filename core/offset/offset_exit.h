#pragma once

#include <Eigen/Core>

#include "shapegauge/core/offset/exterior_grid.h"

namespace shapegauge {

/// Returns the distance (in cells) along a ray with a unit direction, from a point within r of the surface to E(r).
double offset_exit(const ExteriorGrid& exterior, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction);

}  // namespace shapegauge
