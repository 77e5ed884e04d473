#include "shapegauge/core/spatial/triangle_bvh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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

/// Returns the squared distance from x to the box of a node's child.
float squared_distance_to_box(const TriangleBvhNode& node, std::size_t child, const Eigen::Vector3f& x) {
  float sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const float coordinate = x[static_cast<Eigen::Index>(k)];
    const float outside = std::max({node.low[k][child] - coordinate, coordinate - node.high[k][child], 0.0F});
    sum += outside * outside;
  }
  return sum;
}

/// Shrinks a ball by the triangles below a node.
class BallShrinking {
 public:
  BallShrinking(const std::vector<TriangleBvhNode>& nodes, const std::vector<TriangleBvhLeaf>& leaves,
                const std::function<void(std::int32_t, Ball&)>& shrink, Ball& ball)
      : nodes_(nodes), leaves_(leaves), shrink_(shrink), ball_(ball) {}

  void visit(const TriangleBvhNode& node) {
    std::array<std::pair<float, std::size_t>, children_per_node> met;  // squared distances, and which children
    std::size_t count = 0;
    for (std::size_t i = 0; i < children_per_node; ++i) {
      const float square = squared_distance_to_box(node, i, ball_.centre.cast<float>());
      if (square > widened_square_of_radius()) continue;
      std::size_t place = count++;
      for (; place > 0 && met[place - 1].first > square; --place) met[place] = met[place - 1];
      met[place] = {square, i};
    }
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t child = met[i].second;
      const float square = squared_distance_to_box(node, child, ball_.centre.cast<float>());  // it may have shrunk
      if (square <= widened_square_of_radius()) visit_child(node.child[child]);
    }
  }

 private:
  void visit_child(std::int32_t child) {
    if (child >= 0) return visit(nodes_[static_cast<std::size_t>(child)]);
    const std::int32_t leaf = ~child;
    for (const std::int32_t triangle : leaves_[static_cast<std::size_t>(leaf)].triangle) shrink_(triangle, ball_);
  }

  /// Widened by the error of single precision for coordinates of the order of 1.
  [[nodiscard]] float widened_square_of_radius() const { return widened_square(ball_.radius + 1e-6); }

  const std::vector<TriangleBvhNode>& nodes_;
  const std::vector<TriangleBvhLeaf>& leaves_;
  const std::function<void(std::int32_t, Ball&)>& shrink_;
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

Ball TriangleBVH::shrunk_ball(Ball ball, const std::function<void(std::int32_t, Ball&)>& shrink) const {
  if (layout_->nodes.empty()) return ball;
  BallShrinking(layout_->nodes, layout_->leaves, shrink, ball).visit(layout_->nodes.front());
  return ball;
}

const Triangle& TriangleBVH::triangle(std::int32_t index) const {
  return layout_->triangles[static_cast<std::size_t>(index)];
}

}  // namespace shapegauge
