// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/io/triangulate_polygon.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace shapegauge {

namespace {

/// Area attributed to rounding, for a polygon with an extent of 1.
constexpr double negligible_area = 1e-11;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Returns the corners relative to the first one, with an extent of 1, rounded to a fine grid: scaled polygons, with
/// other rounding errors, then have the same triangles.
std::vector<Eigen::Vector3d> normalised(std::span<const Eigen::Vector3d> corners) {
  constexpr double cells = 0x1p40;
  double extent = 0;
  for (const Eigen::Vector3d& corner : corners) {
    extent = std::max(extent, (corner / 2 - corners.front() / 2).cwiseAbs().maxCoeff());  // halves cannot overflow
  }
  std::vector<Eigen::Vector3d> result;
  result.reserve(corners.size());
  for (const Eigen::Vector3d& corner : corners) {
    const Eigen::Vector3d relative = corner / 2 - corners.front() / 2;
    result.emplace_back((relative / (extent > 0 ? extent : 1) * cells).array().round() / cells);
  }
  return result;
}

/// Returns Newell's normal; its length is the polygon's area.
Eigen::Vector3d newell_normal(std::span<const Eigen::Vector3d> corners) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) sum += corners[i].cross(corners[i + 1]);  // the first is 0
  return sum / 2;
}

/// Returns the axis along which the normal is longest. Of nearly equal axes it is the last one, whatever the rounding.
Eigen::Index projection_axis(const Eigen::Vector3d& normal) {
  const double enough = 0.9 * normal.cwiseAbs().maxCoeff();
  for (const Eigen::Index axis : {2, 1}) {
    if (std::abs(normal[axis]) >= enough) return axis;
  }
  return 0;
}

/// Projects the polygon by dropping one coordinate, which keeps the others exact, with positive area.
std::vector<Eigen::Vector2d> projected(std::span<const Eigen::Vector3d> corners, const Eigen::Vector3d& normal) {
  const Eigen::Index axis = projection_axis(normal);
  Eigen::Index u = (axis + 1) % 3;
  Eigen::Index v = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(u, v);
  std::vector<Eigen::Vector2d> flat;
  flat.reserve(corners.size());
  for (const Eigen::Vector3d& corner : corners) flat.emplace_back(corner[u], corner[v]);
  return flat;
}

/// Returns true if the triangles about the first corner, at the origin, do not overlap.
bool fan_covers(std::span<const Eigen::Vector2d> corners) {
  double turned = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const double doubled_area = cross(corners[i], corners[i + 1]);
    if (doubled_area < -negligible_area) return false;
    turned += std::atan2(std::max(0.0, doubled_area), corners[i].dot(corners[i + 1]));
  }
  return turned < 2 * std::numbers::pi * (1 + 1e-9);
}

/// Returns true if the triangles have the polygon's area. It is less if the polygon winds twice about a point.
bool have_area_of(std::span<const PolygonTriangle> triangles, std::span<const Eigen::Vector2d> corners) {
  double polygon = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) polygon += cross(corners[i], corners[i + 1]);
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const Eigen::Vector2d& origin = corners[static_cast<std::size_t>(a)];
    sum += cross(corners[static_cast<std::size_t>(b)] - origin, corners[static_cast<std::size_t>(c)] - origin);
  }
  return std::abs(sum - polygon) <= 1e-9 * polygon + negligible_area;
}

/// Rotates each triangle to begin with its smallest corner, then sorts all in ascending order.
void sort_triangles(std::vector<PolygonTriangle>& triangles) {
  for (PolygonTriangle& triangle : triangles) {
    std::rotate(triangle.begin(), std::ranges::min_element(triangle), triangle.end());
  }
  std::ranges::sort(triangles);
}

}  // namespace

std::vector<PolygonTriangle> triangles_in_place_of_fan(std::span<const Eigen::Vector3d> corners) {
  if (corners.size() < 4) return {};
  const std::vector<Eigen::Vector3d> scaled = normalised(corners);
  const Eigen::Vector3d normal = newell_normal(scaled);
  if (normal.norm() <= negligible_area) return {};
  const std::vector<Eigen::Vector2d> flat = projected(scaled, normal);
  if (fan_covers(flat)) return {};
  std::vector<PolygonTriangle> triangles = constrained_delaunay(flat);
  if (!have_area_of(triangles, flat)) return {};
  sort_triangles(triangles);
  return triangles;
}

}  // namespace shapegauge
