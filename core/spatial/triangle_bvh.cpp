// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/spatial/triangle_bvh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "shapegauge/core/spatial/triangle_bvh_layout.h"

namespace shapegauge {

namespace {

/// Relative error of squared distances in single precision; limits are widened by it, and double precision decides.
constexpr double single_precision_margin = 1e-5;

float widened_square(double distance) {
  const double square = distance * distance * (1 + single_precision_margin);
  return square < std::numeric_limits<float>::max() ? static_cast<float>(square)
                                                    : std::numeric_limits<float>::infinity();
}

/// Visits the leaves in a cone that intersect a ball, while the ball shrinks.
class ConeSearch {
 public:
  using Visit = std::function<void(std::int32_t, Ball&)>;

  ConeSearch(const std::vector<TriangleBvhNode>& nodes, const std::vector<TriangleBvhLeaf>& leaves, const Cone& cone,
             const Visit& visit, Ball& ball)
      : nodes_(nodes),
        leaves_(leaves),
        cone_(cone),
        query_{.centre = {},
               .radius = 0,
               .apex = cone.apex.cast<float>(),
               .axis = cone.axis.cast<float>(),
               .squared_cosine = static_cast<float>(cone.cosine * cone.cosine),
               .sine = static_cast<float>(std::sqrt(std::max(0.0, 1 - cone.cosine * cone.cosine))),
               .min_normal_cosine = static_cast<float>(cone.min_normal_cosine - rounding_)},
        visit_(visit),
        ball_(ball) {
    set_ball();
  }

  void visit(const TriangleBvhNode& node) {
    Keys keys = keys_of(node);
    float radius = query_.radius;
    std::array<std::size_t, children_per_node> order;
    std::size_t count = 0;
    for (std::size_t i = 0; i < children_per_node; ++i) {
      if (!(keys[i] < unreachable)) continue;
      std::size_t rank = count++;
      for (; rank > 0 && keys[order[rank - 1]] > keys[i]; --rank) order[rank] = order[rank - 1];
      order[rank] = i;
    }
    for (std::size_t rank = 0; rank < count; ++rank) {
      if (query_.radius < radius) keys = keys_of(node);
      radius = query_.radius;
      if (keys[order[rank]] < unreachable) visit_child(node.child[order[rank]]);
    }
  }

 private:
  using Keys = std::array<float, children_per_node>;
  static constexpr float unreachable = std::numeric_limits<float>::infinity();

  void visit_child(std::int32_t child) {
    if (child >= 0) return visit(nodes_[static_cast<std::size_t>(child)]);
    const std::int32_t leaf = ~child;
    visit_leaf(leaves_[static_cast<std::size_t>(leaf)]);
  }

  /// Visits the triangles of a leaf, the nearest to the ball's centre first.
  void visit_leaf(const TriangleBvhLeaf& leaf) {
    alignas(64) LeafLane distances;
    float radius = std::numeric_limits<float>::infinity();
    for (std::uint32_t left = triangles_facing(leaf, cone_); left != 0;) {
      if (query_.radius < radius) squared_distances_to_triangles(leaf, ball_.centre, distances);
      radius = query_.radius;
      auto nearest = static_cast<std::size_t>(std::countr_zero(left));
      for (std::uint32_t others = left & (left - 1); others != 0; others &= others - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(others));
        if (distances[lane] < distances[nearest]) nearest = lane;
      }
      if (!(distances[nearest] <= radius * radius * static_cast<float>(1 + single_precision_margin))) break;
      left &= ~(1U << nearest);
      visit_(leaf.triangle[nearest], ball_);
      set_ball();
    }
    visit_(-1, ball_);
    set_ball();
  }

  /// Caches the ball, enlarged by the error of single precision for coordinates of the order of 1.
  void set_ball() {
    query_.centre = ball_.centre.cast<float>();
    query_.radius = static_cast<float>(ball_.radius * (1 + rounding_) + rounding_);
  }

  [[nodiscard]] Keys keys_of(const TriangleBvhNode& node) const {
    alignas(64) Keys keys;
    child_distances_in_reach(node, query_, keys);
    return keys;
  }

  static constexpr double rounding_ = 1e-6;

  const std::vector<TriangleBvhNode>& nodes_;
  const std::vector<TriangleBvhLeaf>& leaves_;
  const Cone& cone_;
  BallAndCone query_;
  const Visit& visit_;
  Ball& ball_;
};

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

void TriangleBVH::search(const Cone& cone, Ball& ball, const ConeSearch::Visit& visit) const {
  if (!layout_->nodes.empty())
    ConeSearch(layout_->nodes, layout_->leaves, cone, visit, ball).visit(layout_->nodes.front());
}

const Triangle& TriangleBVH::triangle(std::int32_t index) const {
  return layout_->triangles[static_cast<std::size_t>(index)];
}

}  // namespace shapegauge
