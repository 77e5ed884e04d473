// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/fields/inscribed_ball.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/fields/touching_ball.h"
#include "shapegauge/core/spatial/morton_order.h"
#include "shapegauge/core/spatial/triangle_bvh.h"

namespace shapegauge {

namespace {

/// Upper bound of the radius of a ball inside a closed shape of diagonal 1.
constexpr double largest_radius = 0.5;

/// Number of triangles and leaves of the tree that are tried exactly. Beyond it, triangles that would shrink the ball
/// by less than `skipped_difference` are skipped: around a sphere or a cylinder nearly all are equally near to the
/// centre.
constexpr int exact_trials = 128;
constexpr int few_exact_trials = 4;  ///< of TouchingBalls::ball_at()
constexpr double skipped_difference = 1e-3;

/// Returns the distance in a shape's unit frame below which its points coincide: its coordinates, and those of samples
/// on its surface, are rounded.
double rounding_of(const UnitFrame& frame) {
  constexpr double minimum = 1e-9;
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double largest = frame.centre.cwiseAbs().maxCoeff() + frame.diagonal / 2;
  return std::max(minimum, 4 * epsilon * largest / frame.diagonal);
}

const Shape& checked(const Shape& shape, const InscribedBallOptions& options) {
  check_options("inscribed_ball", inscribed_ball_table, options);
  require_usable(shape);
  if (is_cloud(shape) && shape.normals.isZero(0)) {
    throw InputError(
        "inscribed balls need outward normals, and the points have none or wrong ones; estimate normals first "
        "(shapegauge normals)");
  }
  return shape;
}

}  // namespace

/// Shrinks balls until they contain nothing opposite to the sample, in the unit frame of the shape. They shrink from
/// triangle to triangle, like those of Ma, Bae and Choi (2012, 3D medial axis point approximation using nearest
/// neighbors and the normal field) from point to point.
class TouchingBalls::Search {
 public:
  Search(const Shape& shape, const InscribedBallOptions& options)
      : parallel(options.parallel),
        shape_(checked(shape, options)),
        frame_(unit_frame(shape)),
        rounding_(rounding_of(frame_)),
        tree_(in_unit_frame(shape, frame_)),
        min_cosine_(-std::cos(options.separation_angle_degrees / 180 * std::numbers::pi)),
        cone_cosine_(std::sin(options.separation_angle_degrees / 360 * std::numbers::pi)) {
    for (std::int32_t i = 0; i < shape.triangles.rows(); ++i) normals_.push_back(oriented_normal(tree_.triangle(i)));
  }

  /// Returns the diameter of the ball at a sample, in the shape's units; NaN without normal or ball.
  [[nodiscard]] double diameter_at(const Eigen::Vector3d& sample, const Eigen::Vector3d& normal, BallSide side) const {
    constexpr double missing = std::numeric_limits<double>::quiet_NaN();
    if (normal.isZero(0)) return missing;
    const double radius = stop_at(frame_.to_unit(sample), normal, side, largest_radius, exact_trials).radius;
    return radius < largest_radius ? 2 * radius * frame_.diagonal : missing;
  }

  /// See TouchingBalls::ball_at().
  [[nodiscard]] std::optional<TouchingBall> ball_at(const Eigen::Vector3d& sample, const Eigen::Vector3d& normal,
                                                    BallSide side, double limit) const {
    if (normal.isZero(0)) return std::nullopt;
    const Eigen::Vector3d point = frame_.to_unit(sample);
    const double start = std::min(largest_radius, limit / (2 * frame_.diagonal));
    const Stop stop = stop_at(point, normal, side, start, few_exact_trials);
    if (!(stop.radius < start)) return std::nullopt;
    const Eigen::Vector3d centre = point + stop.radius * direction_of(normal, side);
    const Eigen::Vector3d contact = closest_point(tree_.triangle(stop.triangle), centre);
    const double half_sine = std::min(1.0, (contact - point).norm() / (2 * stop.radius));
    const double angle = std::max(2 * std::asin(half_sine), opposite_angle(stop.triangle, normal));
    return TouchingBall{.diameter = 2 * stop.radius * frame_.diagonal,
                        .contact = frame_.centre + frame_.diagonal * contact,
                        .angle_degrees = angle / std::numbers::pi * 180};
  }

  /// See TouchingBalls::may_touch().
  [[nodiscard]] bool may_touch(const Triangle& part, const Eigen::Vector3d& normal, BallSide side, double limit) const {
    const Corners corners{frame_.to_unit(part.a), frame_.to_unit(part.b), frame_.to_unit(part.c)};
    const Eigen::Vector3d direction = direction_of(normal, side);
    const Eigen::Vector3d middle = (corners[0] + corners[1] + corners[2]) / 3;
    double extent = 0;
    for (const Eigen::Vector3d& corner : corners) extent = std::max(extent, (corner - middle).norm());
    // This cone contains those of all points of the part.
    const double back = extent * cone_cosine_ / std::sqrt(1 - cone_cosine_ * cone_cosine_);
    Ball ball{.centre = middle, .radius = extent + limit / frame_.diagonal};
    bool found = false;
    tree_.search({middle - back * direction, direction, cone_cosine_, min_normal_cosine()}, ball,
                 [&](std::int32_t triangle, Ball& searched) {
                   found =
                       found || (triangle >= 0 && is_opposite(triangle, corners, middle, direction, searched.radius));
                   if (found) searched.radius = 0;
                 });
    return found;
  }

  bool parallel;

 private:
  using Corners = std::array<Eigen::Vector3d, 3>;

  /// Radius and triangle, or point, at which a ball stops.
  struct Stop {
    double radius;
    std::int32_t triangle;
  };

  /// Returns Cone::min_normal_cosine; points of a cloud have normals of their own.
  [[nodiscard]] double min_normal_cosine() const { return is_cloud(shape_) ? -1 : min_cosine_ - rounding_; }

  /// Returns the angle between a unit normal and that of a triangle, or point, at least 90 degrees.
  [[nodiscard]] double opposite_angle(std::int32_t triangle, const Eigen::Vector3d& normal) const {
    const Eigen::Vector3d other = is_cloud(shape_) ? Eigen::Vector3d(shape_.normals.row(triangle).transpose())
                                                   : normals_[static_cast<std::size_t>(triangle)];
    return std::numbers::pi - std::acos(std::min(1.0, std::abs(other.dot(normal))));
  }

  static Eigen::Vector3d direction_of(const Eigen::Vector3d& normal, BallSide side) {
    return side == BallSide::inside ? Eigen::Vector3d(-normal) : normal;
  }

  /// Shrinks a ball from the radius `start` until no opposite point is inside. Searches straight ahead first, which
  /// nearly gives the result between parallel walls. After `exact` trials, small improvements are skipped.
  [[nodiscard]] Stop stop_at(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, BallSide side, double start,
                             int exact) const {
    const Eigen::Vector3d direction = direction_of(normal, side);
    const auto ball_of = [&](double radius) { return Ball{.centre = point + radius * direction, .radius = radius}; };
    const OppositePoints opposite{direction, cone_cosine_, min_cosine_, rounding_};
    Stop stop{.radius = start, .triangle = -1};
    for (const bool ahead : {true, false}) {
      double limit = stop.radius;
      int trials = 0;
      Ball ball = ball_of(limit);
      const Cone cone{point, direction, ahead ? 1 : cone_cosine_, min_normal_cosine(), true};
      tree_.search(cone, ball, [&](std::int32_t triangle, Ball& searched) {
        const double found = triangle < 0 ? limit : radius_at(point, normal, opposite, triangle, limit);
        if (found < limit) stop = {.radius = found, .triangle = triangle};
        limit = ++trials > exact ? (1 - skipped_difference) * stop.radius : stop.radius;
        searched = ball_of(limit);
      });
    }
    return stop;
  }

  /// Returns true if a triangle may be opposite to a point of a part of the surface, within a distance from its middle.
  [[nodiscard]] bool is_opposite(std::int32_t index, const Corners& part, const Eigen::Vector3d& middle,
                                 const Eigen::Vector3d& direction, double distance) const {
    const Triangle& triangle = tree_.triangle(index);
    const Eigen::Vector3d& normal = normals_[static_cast<std::size_t>(index)];
    const double depth = direction.dot(middle) + rounding_;
    if (direction.dot(triangle.a) < depth && direction.dot(triangle.b) < depth && direction.dot(triangle.c) < depth) {
      return false;
    }
    const double cosine = normal.dot(direction);
    if (normal.isZero(0) || std::abs(cosine) < min_cosine_ - rounding_) return false;
    // The side of the triangle that faces away from the part.
    const auto faces_away = [&](const Eigen::Vector3d& corner) {
      return std::copysign(1.0, cosine) * normal.dot(triangle.a - corner) > -rounding_;
    };
    if (min_cosine_ > 0 && std::ranges::none_of(part, faces_away)) return false;
    return (closest_point(triangle, middle) - middle).norm() <= distance;
  }

  /// Returns the radius at which a triangle, or a point of a cloud, stops the ball; infinity if it does not; any value
  /// above the limit if the radius is not below it.
  [[nodiscard]] double radius_at(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                                 const OppositePoints& opposite, std::int32_t index, double limit) const {
    const Triangle& triangle = tree_.triangle(index);
    const Triangle relative{triangle.a - point, triangle.b - point, triangle.c - point};
    if (is_cloud(shape_)) {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      const bool is_opposite = -shape_.normals.row(index).dot(normal) >= min_cosine_;
      return is_opposite ? touching_radius(relative.a, opposite) : infinity;
    }
    return touching_radius(relative, normals_[static_cast<std::size_t>(index)], opposite, limit);
  }

  const Shape& shape_;
  UnitFrame frame_;
  double rounding_;
  TriangleBVH tree_;
  std::vector<Eigen::Vector3d> normals_;  ///< of the triangles
  double min_cosine_;                     ///< OppositePoints
  double cone_cosine_;
};

TouchingBalls::TouchingBalls(const Shape& shape, const InscribedBallOptions& options)
    : search_(std::make_unique<Search>(shape, options)) {}
TouchingBalls::~TouchingBalls() = default;
TouchingBalls::TouchingBalls(TouchingBalls&&) noexcept = default;
TouchingBalls& TouchingBalls::operator=(TouchingBalls&&) noexcept = default;

Eigen::VectorXd TouchingBalls::diameters(const Samples& samples, BallSide side) const {
  if (samples.normals.rows() != samples.points.rows()) {
    throw InputError(
        fmt::format("the samples have {} normals for {} points", samples.normals.rows(), samples.points.rows()));
  }
  Eigen::VectorXd diameters(samples.points.rows());
  const std::vector<std::int32_t> order = morton_order(samples.points);  // for the sake of the processor's caches
  for_each_index(search_->parallel, std::size_t{0}, order.size(), [&](std::size_t k) {
    const Eigen::Index i = order[k];
    diameters[i] = search_->diameter_at(samples.points.row(i).transpose(), samples.normals.row(i).transpose(), side);
  });
  return diameters;
}

std::optional<TouchingBall> TouchingBalls::ball_at(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                                                   BallSide side, double limit) const {
  return search_->ball_at(point, normal, side, limit);
}

bool TouchingBalls::may_touch(const Triangle& part, const Eigen::Vector3d& normal, BallSide side, double limit) const {
  return search_->may_touch(part, normal, side, limit);
}

Eigen::VectorXd inscribed_ball(const Shape& shape, const Samples& samples, const InscribedBallOptions& options) {
  return TouchingBalls(shape, options).diameters(samples, BallSide::inside);
}

}  // namespace shapegauge
