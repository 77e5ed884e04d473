#include "tests/oracle/surface_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace shapegauge {

namespace {

/// How a ray meets a triangle: not at all, through its inside along its normal or against it, or too close to its
/// border to say.
enum class Crossing { none, along, against, border };

Crossing crossing(const Triangle& triangle, const Eigen::Vector3d& x, const Eigen::Vector3d& direction) {
  constexpr double border_width = 1e-9;
  const Eigen::Vector3d ab = triangle.b - triangle.a;
  const Eigen::Vector3d ac = triangle.c - triangle.a;
  const Eigen::Vector3d p = direction.cross(ac);
  const double determinant = ab.dot(p);
  if (std::abs(determinant) <= 1e-12 * ab.norm() * ac.norm()) {
    // The ray runs in the triangle's plane: it matters only where it could touch the triangle.
    const Eigen::Vector3d nearest = closest_point(triangle, x);
    const double along = (nearest - x).dot(direction);
    return (nearest - x - along * direction).norm() <= ab.norm() + ac.norm() ? Crossing::border : Crossing::none;
  }
  const Eigen::Vector3d s = x - triangle.a;
  const Eigen::Vector3d q = s.cross(ab);
  const double v = s.dot(p) / determinant;
  const double w = direction.dot(q) / determinant;
  const double margin = std::min({v, w, 1 - v - w});
  if (margin < -border_width || ac.dot(q) / determinant < 0) return Crossing::none;
  if (margin <= border_width) return Crossing::border;
  return determinant < 0 ? Crossing::along : Crossing::against;
}

}  // namespace

SurfaceTree::SurfaceTree(const Shape& shape) : tree_(shape) {
  const Eigen::Index count = is_cloud(shape) ? shape.vertices.rows() : shape.triangles.rows();
  for (Eigen::Index i = 0; i < count; ++i) triangles_.push_back(tree_.triangle(static_cast<std::int32_t>(i)));
}

std::array<SurfaceTree::Nearest, SurfaceTree::most_points_at_once> SurfaceTree::closest_to_each(
    std::span<const Eigen::Vector3d> points, double max_distance) const {
  std::array<Nearest, most_points_at_once> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto hit = tree_.closest(points[i], max_distance);
    if (hit) result[i] = {hit->triangle, static_cast<float>(hit->distance)};
  }
  return result;
}

std::optional<std::int32_t> SurfaceTree::any_within(const Eigen::Vector3d& x, double distance) const {
  const auto hit = tree_.closest(x, distance);
  if (!hit) return std::nullopt;
  return hit->triangle;
}

std::optional<RayParity> SurfaceTree::ray_parity(const Eigen::Vector3d& x, const Eigen::Vector3d& direction) const {
  RayParity crossings;
  for (const Triangle& triangle : triangles_) {
    const Crossing found = crossing(triangle, x, direction);
    if (found == Crossing::border) return std::nullopt;
    crossings.count += found == Crossing::none ? 0 : 1;
    crossings.balance += found == Crossing::along ? 1 : found == Crossing::against ? -1 : 0;
  }
  return crossings;
}

}  // namespace shapegauge
