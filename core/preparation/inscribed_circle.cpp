#include "shapegauge/core/preparation/inscribed_circle.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

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

/// A square in which the centre may lie.
struct Square {
  Eigen::Vector2d centre;
  double half;   ///< of its edge
  double bound;  ///< no circle about a point of the square is larger
};

}  // namespace

double inscribed_circle_radius(const std::vector<Eigen::Vector2d>& polygon) {
  if (polygon.size() < 3) return 0;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& corner : polygon) box.extend(corner);
  const double negligible = 1e-3 * box.diagonal().norm();
  double best = 0;
  const auto smaller_bound = [](const Square& a, const Square& b) { return a.bound < b.bound; };
  std::priority_queue<Square, std::vector<Square>, decltype(smaller_bound)> waiting(smaller_bound);
  const auto look_at = [&](const Eigen::Vector2d& centre, double half) {
    const double distance = signed_distance(polygon, centre);
    best = std::max(best, distance);
    // Distances change by no more than the way from the centre.
    waiting.push({centre, half, distance + std::sqrt(2.0) * half});
  };
  look_at(box.center(), box.sizes().maxCoeff() / 2);
  while (waiting.top().bound > 1.01 * best + negligible) {
    const Square square = waiting.top();
    waiting.pop();
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-0.5, 0.5}) look_at(square.centre + square.half * Eigen::Vector2d(x, y), square.half / 2);
    }
  }
  return best;
}

}  // namespace shapegauge
