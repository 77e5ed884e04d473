#pragma once

#include <Eigen/Core>

#include "shapegauge/core/offset/exterior_grid.h"

namespace shapegauge {

/// How far along the ray (in cells, direction of length 1) E(r) begins, from a point within r of the surface.
double offset_exit(const ExteriorGrid& exterior, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction);

}  // namespace shapegauge
