#include "shapegauge/core/fields/inscribed_ball.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel_parts.h"
#include "shapegauge/core/fields/touching_ball.h"
#include "shapegauge/core/spatial/morton_order.h"
#include "shapegauge/core/spatial/triangle_bvh.h"

namespace shapegauge {

namespace {

/// Upper bound of the radius of a ball inside a closed shape of diagonal 1.
constexpr double largest_radius = 0.5;

/// Returns the distance in a shape's unit frame below which its points coincide: its coordinates, and those of samples
/// on its surface, are rounded.
double rounding_of(const Shape& shape, const UnitFrame& frame) {
  constexpr double usual = 1e-9;
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  return std::max(usual, 4 * epsilon * shape.vertices.cwiseAbs().maxCoeff() / frame.diagonal);
}

void check(const Shape& shape, const Samples& samples, const InscribedBallOptions& options) {
  check_options("inscribed_ball", inscribed_ball_table, options);
  require_usable(shape);
  if (is_cloud(shape) && shape.normals.rows() == 0) {
    throw InputError(
        "inscribed balls need outward normals, and the points have none; estimate them first (shapegauge normals)");
  }
  if (samples.normals.rows() != samples.points.rows()) {
    throw InputError(
        fmt::format("the samples have {} normals for {} points", samples.normals.rows(), samples.points.rows()));
  }
}

/// Shrinks balls until nothing that faces them intersects them, in the unit frame of the shape.
class ShrinkingBalls {
 public:
  ShrinkingBalls(const Shape& shape, double separation_angle_degrees)
      : shape_(shape),
        frame_(unit_frame(shape)),
        rounding_(rounding_of(shape, frame_)),
        tree_(in_unit_frame(shape, frame_)),
        most_cosine_(std::cos(separation_angle_degrees / 180 * std::numbers::pi)) {
    for (std::int32_t i = 0; i < shape.triangles.rows(); ++i) normals_.push_back(oriented_normal(tree_.triangle(i)));
  }

  /// Returns the diameter at a sample, in the shape's units; NaN without a normal or ball. `hint` is a triangle that
  /// probably stops the ball, replaced by the one that does. It saves time and changes no value.
  [[nodiscard]] double diameter_at(const Eigen::Vector3d& sample, const Eigen::Vector3d& normal,
                                   std::int32_t& hint) const {
    const Eigen::Vector3d inward = -normal;
    if (inward.isZero(0)) return std::numeric_limits<double>::quiet_NaN();
    const Eigen::Vector3d point = frame_.to_unit(sample);
    const auto ball_of = [&](double radius) { return Ball{.centre = point + radius * inward, .radius = radius}; };
    const auto shrink = [&](std::int32_t index, Ball& now) {
      const double radius = radius_at(point, inward, index, now.radius);
      if (!(radius < now.radius)) return;
      now = ball_of(radius);
      hint = index;
    };
    Ball ball = ball_of(largest_radius);
    if (hint >= 0) shrink(hint, ball);
    ball = tree_.shrunk_ball(ball, shrink);
    return ball.radius < largest_radius ? 2 * ball.radius * frame_.diagonal : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  /// Returns the radius at which a triangle, or a point of a cloud, stops the ball at a point; infinity if it does not
  /// face the ball; any value above the limit if the radius is not below it.
  [[nodiscard]] double radius_at(const Eigen::Vector3d& point, const Eigen::Vector3d& inward, std::int32_t index,
                                 double limit) const {
    const auto faces = [&](const Eigen::Vector3d& outward) { return -inward.dot(outward) <= most_cosine_; };
    const Triangle& triangle = tree_.triangle(index);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (is_cloud(shape_)) {
      if (!faces(shape_.normals.row(index).transpose())) return infinity;
      return touching_radius(triangle.a - point, inward, rounding_);
    }
    const Eigen::Vector3d& normal = normals_[static_cast<std::size_t>(index)];
    if (normal.isZero(0)) return infinity;
    const FacingTriangle facing(triangle, point, normal, rounding_);
    return faces(facing.away()) ? touching_radius(facing, inward, limit) : infinity;
  }

  const Shape& shape_;
  UnitFrame frame_;
  double rounding_;
  TriangleBVH tree_;
  std::vector<Eigen::Vector3d> normals_;  ///< of the triangles
  double most_cosine_;                    ///< between the outward normals of the sample and what stops its ball
};

}  // namespace

Eigen::VectorXd inscribed_ball(const Shape& shape, const Samples& samples, const InscribedBallOptions& options) {
  check(shape, samples, options);
  const ShrinkingBalls balls(shape, options.separation_angle_degrees);
  Eigen::VectorXd diameters(samples.points.rows());
  const std::vector<std::int32_t> order = morton_order(samples.points);
  const auto measure = [&](const tbb::blocked_range<Eigen::Index>& range) {
    std::int32_t hint = -1;
    for (Eigen::Index k = range.begin(); k < range.end(); ++k) {
      check_interruption();
      const Eigen::Index i = order[static_cast<std::size_t>(k)];
      diameters[i] = balls.diameter_at(samples.points.row(i).transpose(), samples.normals.row(i).transpose(), hint);
    }
  };
  const tbb::blocked_range<Eigen::Index> all(0, samples.points.rows(), 256);
  if (options.parallel) {
    parallel_for_parts(all, measure);
  } else {
    measure(all);
  }
  return diameters;
}

}  // namespace shapegauge
