// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shapegauge/core/shape/shape.h"
#include "tests/support/test_shapes.h"

namespace shapegauge::test {

/// A dumbbell along z: two balls of radius 1 about z = -2.5 and z = 2.5, joined by a bar of radius 0.25. A sphere whose
/// points are moved by height.
inline Shape dumbbell(int subdivisions) {
  Shape shape = sphere(1, subdivisions);
  for (Eigen::Index v = 0; v < shape.vertices.rows(); ++v) {
    Eigen::RowVector3d position = shape.vertices.row(v);
    const double height = 3.5 * std::asin(std::clamp(position.z(), -1.0, 1.0)) * 2 / std::numbers::pi;
    const double from_ball = std::min(1.0, std::abs(std::abs(height) - 2.5));
    const double ball = std::sqrt(1 - from_ball * from_ball);
    const double radius = std::abs(height) < 2.5 ? std::max(0.25, ball) : ball;
    const double around = std::hypot(position.x(), position.y());
    if (around > 0) position.head<2>() *= radius / around;
    position.z() = height;
    shape.vertices.row(v) = position;
  }
  return shape;
}

}  // namespace shapegauge::test
