// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge::test {

/// Computes the diameter of inscribed_ball() at one point of a mesh directly from its definition, by subdividing every
/// triangle, to test the fast implementation. `direction` is the unit vector from the point to the ball's centre. NaN
/// if the diameter reaches the bounding-box diagonal.
double touching_ball_by_definition(const Shape& mesh, const Eigen::Vector3d& point, const Eigen::Vector3d& direction,
                                   double separation_angle_degrees);

}  // namespace shapegauge::test
