#include "shapegauge/core/spatial/closest_point.h"

#include <Eigen/Geometry>
#include <algorithm>

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
  if (normal2 > 0) {
    const double v = ax.cross(ac).dot(normal) / normal2;
    const double w = ab.cross(ax).dot(normal) / normal2;
    if (v >= 0 && w >= 0 && v + w <= 1) return a + v * ab + w * ac;
  }
  Eigen::Vector3d best = closest_point_on_segment(a, b, x);
  for (const Eigen::Vector3d& other : {closest_point_on_segment(b, c, x), closest_point_on_segment(c, a, x)}) {
    if ((other - x).squaredNorm() < (best - x).squaredNorm()) best = other;
  }
  return best;
}

}  // namespace shapegauge
