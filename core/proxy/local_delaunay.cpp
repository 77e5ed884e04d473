// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/proxy/local_delaunay.h"

#include <algorithm>
#include <tuple>

namespace shapegauge {

namespace {

/// Point after inversion in the unit circle. The Delaunay neighbours of the origin are the vertices of the convex hull
/// of the inverted points and the origin.
struct InvertedPoint {
  Eigen::Vector2d position;
  std::int32_t index;  ///< -1: the origin
};

double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Andrew's monotone chain, counterclockwise.
std::vector<InvertedPoint> convex_hull(std::vector<InvertedPoint> points) {
  std::ranges::sort(points, {},
                    [](const InvertedPoint& p) { return std::tuple(p.position.x(), p.position.y(), p.index); });
  std::vector<InvertedPoint> hull;
  const auto extend = [&hull](const InvertedPoint& p, std::size_t keep) {
    while (hull.size() >= keep + 2 && turn(hull[hull.size() - 2].position, hull.back().position, p.position) <= 0) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const InvertedPoint& p : points) extend(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p) extend(*p, lower);
  hull.pop_back();
  return hull;
}

}  // namespace

std::vector<std::array<std::int32_t, 2>> delaunay_star(std::span<const Eigen::Vector2d> points) {
  std::vector<InvertedPoint> inverted{{Eigen::Vector2d::Zero(), -1}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double squared = points[i].squaredNorm();
    if (squared > 0) inverted.push_back({points[i] / squared, static_cast<std::int32_t>(i)});
  }
  std::vector<std::array<std::int32_t, 2>> triangles;
  if (inverted.size() < 3) return triangles;
  const std::vector<InvertedPoint> hull = convex_hull(std::move(inverted));
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const InvertedPoint& a = hull[k];
    const InvertedPoint& b = hull[(k + 1) % hull.size()];
    if (a.index >= 0 && b.index >= 0 && turn({0, 0}, a.position, b.position) > 0)
      triangles.push_back({a.index, b.index});
  }
  return triangles;
}

}  // namespace shapegauge
