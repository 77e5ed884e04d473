#include "shapegauge/core/spatial/triangle_bvh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "shapegauge/core/spatial/triangle_bvh_layout.h"

namespace shapegauge {

namespace {

/// Single precision may lose this much of a squared distance; limits are widened by it, and double precision decides.
constexpr double single_precision_margin = 1e-5;

float widened_square(double distance) {
  const double square = distance * distance * (1 + single_precision_margin);
  return square < std::numeric_limits<float>::max() ? static_cast<float>(square)
                                                    : std::numeric_limits<float>::infinity();
}

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

bool ray_meets_box(const TriangleBvhNode& node, std::size_t child, const Eigen::Vector3d& x,
                   const Eigen::Vector3d& inverse_direction) {
  double enter = 0;
  double leave = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const double t0 = (static_cast<double>(node.low[k][child]) - x[axis]) * inverse_direction[axis];
    const double t1 = (static_cast<double>(node.high[k][child]) - x[axis]) * inverse_direction[axis];
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
  }
  return enter <= leave;
}

}  // namespace

TriangleBVH::TriangleBVH(const Shape& shape) : layout_(std::make_unique<Layout>()) {
  if (is_cloud(shape)) {
    layout_->triangles.reserve(static_cast<std::size_t>(shape.vertices.rows()));
    for (const auto& row : shape.vertices.rowwise()) {
      const Eigen::Vector3d point = row.transpose();
      layout_->triangles.push_back({point, point, point});
    }
  }
  layout_->triangles.reserve(static_cast<std::size_t>(shape.triangles.rows()));
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const auto corner = [&](int k) -> Eigen::Vector3d { return shape.vertices.row(shape.triangles(f, k)); };
    layout_->triangles.push_back({corner(0), corner(1), corner(2)});
  }
  if (!layout_->triangles.empty()) build_triangle_bvh(layout_->nodes, layout_->leaves, layout_->triangles);
}

TriangleBVH::~TriangleBVH() = default;
TriangleBVH::TriangleBVH(TriangleBVH&&) noexcept = default;
TriangleBVH& TriangleBVH::operator=(TriangleBVH&&) noexcept = default;

std::optional<ClosestHit> TriangleBVH::closest(const Eigen::Vector3d& x, double max_distance, std::int32_t hint) const {
  if (layout_->nodes.empty()) return std::nullopt;
  double limit = max_distance;
  if (hint >= 0) limit = std::min(limit, (closest_point(triangle(hint), x) - x).norm());
  const std::int32_t found = closest_triangle(layout_->nodes, layout_->leaves, x, widened_square(limit), hint);
  if (found < 0) return std::nullopt;
  const Eigen::Vector3d point = closest_point(triangle(found), x);
  const double distance = (point - x).norm();
  if (!(distance < max_distance)) return std::nullopt;
  return ClosestHit{found, distance, point};
}

std::array<TriangleBVH::Nearest, TriangleBVH::most_points_at_once> TriangleBVH::closest_to_each(
    std::span<const Eigen::Vector3d> points, double max_distance, double enough) const {
  std::array<Nearest, most_points_at_once> result;
  if (layout_->nodes.empty() || points.empty()) return result;
  std::array<float, most_points_at_once> limits{};
  std::array<std::int32_t, most_points_at_once> triangles{};
  limits.fill(widened_square(max_distance));
  triangles.fill(-1);
  closest_triangles(layout_->nodes, layout_->leaves, points, static_cast<float>(enough * enough),
                    std::span(limits).first(points.size()), std::span(triangles).first(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (triangles[i] >= 0) result[i] = {triangles[i], std::sqrt(limits[i])};
  }
  return result;
}

std::optional<std::int32_t> TriangleBVH::any_within(const Eigen::Vector3d& x, double distance,
                                                    std::int32_t hint) const {
  if (layout_->nodes.empty() || !(distance > 0)) return std::nullopt;
  if (hint >= 0 && (closest_point(triangle(hint), x) - x).squaredNorm() < distance * distance) return hint;
  const std::int32_t found =
      any_triangle_within(layout_->nodes, layout_->leaves, x, static_cast<float>(distance * distance));
  return found < 0 ? std::nullopt : std::optional(found);
}

std::optional<RayParity> TriangleBVH::ray_parity(const Eigen::Vector3d& x, const Eigen::Vector3d& direction) const {
  RayParity crossings;
  if (layout_->nodes.empty()) return crossings;
  const Eigen::Vector3d inverse_direction = direction.cwiseInverse();
  std::vector<std::int32_t> stack{0};
  while (!stack.empty()) {
    const TriangleBvhNode& node = layout_->nodes[static_cast<std::size_t>(stack.back())];
    stack.pop_back();
    for (std::size_t i = 0; i < children_per_node; ++i) {
      if (!(node.low[0][i] <= node.high[0][i]) || !ray_meets_box(node, i, x, inverse_direction)) continue;
      if (node.child[i] >= 0) {
        stack.push_back(node.child[i]);
        continue;
      }
      std::int32_t previous = -1;
      for (const std::int32_t index : layout_->leaves[static_cast<std::size_t>(~node.child[i])].triangle) {
        if (index == previous) continue;
        previous = index;
        const Crossing found = crossing(triangle(index), x, direction);
        if (found == Crossing::border) return std::nullopt;
        crossings.count += found == Crossing::none ? 0 : 1;
        crossings.balance += found == Crossing::along ? 1 : found == Crossing::against ? -1 : 0;
      }
    }
  }
  return crossings;
}

const Triangle& TriangleBVH::triangle(std::int32_t index) const {
  return layout_->triangles[static_cast<std::size_t>(index)];
}

}  // namespace shapegauge
