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

const Triangle& TriangleBVH::triangle(std::int32_t index) const {
  return layout_->triangles[static_cast<std::size_t>(index)];
}

}  // namespace shapegauge
