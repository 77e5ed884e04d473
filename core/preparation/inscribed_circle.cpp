#include "shapegauge/core/preparation/inscribed_circle.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace shapegauge {

namespace {

/// Distance from x to the polygon's sides; negative outside of it (even-odd rule).
double signed_distance(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& x) {
  double squared = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    const Eigen::Vector2d ab = b - a;
    const double length = ab.squaredNorm();
    const double t = length > 0 ? std::clamp(ab.dot(x - a) / length, 0.0, 1.0) : 0;
    squared = std::min(squared, (a + t * ab - x).squaredNorm());
    const bool crosses = (a.y() > x.y()) != (b.y() > x.y());
    if (crosses && x.x() < a.x() + (x.y() - a.y()) / ab.y() * ab.x()) inside = !inside;
  }
  return inside ? std::sqrt(squared) : -std::sqrt(squared);
}

}  // namespace

double inscribed_circle_radius(const std::vector<Eigen::Vector2d>& polygon) {
  if (polygon.size() < 3) return 0;
  constexpr int steps = 12;  // of the grid along each axis
  constexpr int rounds = 5;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& corner : polygon) box.extend(corner);
  Eigen::Vector2d centre = box.center();
  Eigen::Vector2d half = box.sizes() / 2;
  double best = 0;
  for (int round = 0; round < rounds; ++round) {
    Eigen::Vector2d next = centre;
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; j <= steps; ++j) {
        const Eigen::Vector2d x = centre + half.cwiseProduct(Eigen::Vector2d(2.0 * i / steps - 1, 2.0 * j / steps - 1));
        const double distance = signed_distance(polygon, x);
        if (distance <= best) continue;
        best = distance;
        next = x;
      }
    }
    centre = next;
    half *= 2.0 / steps;
  }
  return best;
}

}  // namespace shapegauge
