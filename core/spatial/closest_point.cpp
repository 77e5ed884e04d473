// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/spatial/closest_point.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace shapegauge {

Eigen::Vector3d closest_point_on_segment(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& x) {
  const Eigen::Vector3d ab = b - a;
  const double length2 = ab.squaredNorm();
  if (!(length2 > 0)) return a;
  return a + std::clamp(ab.dot(x - a) / length2, 0.0, 1.0) * ab;
}

Eigen::Vector3d closest_point(const Triangle& triangle, const Eigen::Vector3d& x) {
  const auto& [a, b, c] = triangle;
  const Eigen::Vector3d ab = b - a;
  const Eigen::Vector3d ac = c - a;
  const Eigen::Vector3d ax = x - a;
  const Eigen::Vector3d normal = ab.cross(ac);
  const double normal2 = normal.squaredNorm();
  // x is nearest to an edge that it is outside of; if undefined (no area, NaN), to any.
  bool outside_ab = true;
  bool outside_ac = true;
  bool outside_bc = true;
  if (normal2 > 0) {
    const Eigen::Vector3d along = normal.cross(ax) / normal2;
    const double v = along.dot(ac);
    const double w = -along.dot(ab);
    if (v >= 0 && w >= 0 && v + w <= 1) return a + v * ab + w * ac;
    outside_ab = !(w >= 0);
    outside_ac = !(v >= 0);
    outside_bc = !(v + w <= 1);
  }
  Eigen::Vector3d best = a;
  double best_distance2 = std::numeric_limits<double>::infinity();
  const auto offer = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const Eigen::Vector3d point = closest_point_on_segment(from, to, x);
    const double distance2 = (point - x).squaredNorm();
    if (!(distance2 < best_distance2)) return;
    best = point;
    best_distance2 = distance2;
  };
  if (outside_ab) offer(a, b);
  if (outside_bc) offer(b, c);
  if (outside_ac) offer(c, a);
  return best;
}

}  // namespace shapegauge
