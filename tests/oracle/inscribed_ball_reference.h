// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge::test {

/// Computes the diameter of the ball of inscribed_ball() at one point of a mesh literally by the definition, with every
/// triangle. `direction` is the unit direction to the ball's centre. NaN if the diameter reaches the diagonal.
double touching_ball_by_definition(const Shape& mesh, const Eigen::Vector3d& point, const Eigen::Vector3d& direction,
                                   double separation_angle_degrees);

}  // namespace shapegauge::test
