// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <rapidcheck.h>

#include "shapegauge/core/spatial/closest_point.h"

namespace shapegauge {

/// A point with coordinates from -1 to 1, for a RapidCheck property.
inline Eigen::Vector3d random_point() {
  const auto coordinate = [] { return *rc::gen::inRange(-1000, 1001) / 1000.0; };
  const double x = coordinate();
  const double y = coordinate();
  return {x, y, coordinate()};
}

/// A triangle, sometimes degenerate, for a RapidCheck property.
inline Triangle random_triangle() {
  const Eigen::Vector3d a = random_point();
  const Eigen::Vector3d b = random_point();
  const int kind = *rc::gen::inRange(0, 8);
  if (kind == 0) return {a, b, a};
  if (kind == 1) return {a, a, a};
  return {a, b, random_point()};
}

}  // namespace shapegauge
