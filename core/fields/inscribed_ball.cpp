#include "shapegauge/core/fields/inscribed_ball.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <tbb/blocked_range.h>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/spatial/morton_order.h"
#include "shapegauge/core/spatial/triangle_bvh.h"

namespace shapegauge {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Squared distance below which a point coincides with the sample, for a shape of diagonal 1.
constexpr double at_sample = 1e-18;

/// Returns the radius of the ball that touches a plane at the origin, and the point q; infinity if q is not above the
/// plane.
double radius_through(const Eigen::Vector3d& q, const Eigen::Vector3d& normal) {
  const double height = q.dot(normal);
  const double square = q.squaredNorm();
  return height > 0 && square > at_sample ? square / (2 * height) : infinity;
}

/// Returns the same for a segment: for the point where the ball touches its line, or for an end.
double radius_to_segment(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& normal) {
  const double at_end = radius_through(from, normal);  // the other end belongs to the next segment
  const Eigen::Vector3d side = to - from;
  const double length = side.norm();
  if (!(length > 0)) return at_end;
  const Eigen::Vector3d direction = side / length;
  const double from_along = from.dot(direction);
  const double normal_along = normal.dot(direction);
  // The distance from the ball's centre to the line is its radius r: (n.d)^2 r^2 + 2 b r = a.
  const double a = from.squaredNorm() - from_along * from_along;
  const double b = from.dot(normal) - from_along * normal_along;
  const double root = b + std::sqrt(std::max(0.0, b * b + normal_along * normal_along * a));
  if (!(root > 0)) return at_end;
  const double along = a / root * normal_along - from_along;
  return along > 0 && along < length ? std::min(at_end, radius_through(from + along * direction, normal)) : at_end;
}

/// Returns the unit normal by the order of the corners; zero for a degenerate triangle.
Eigen::Vector3d normal_of(const Triangle& triangle) {
  const Eigen::Vector3d area = (triangle.b - triangle.a).cross(triangle.c - triangle.a);
  const double size = area.norm();
  return size > 0 ? Eigen::Vector3d(area / size) : Eigen::Vector3d::Zero();
}

/// Triangle relative to an origin, with its plane.
struct FacingTriangle {
  std::array<Eigen::Vector3d, 3> corners;
  Eigen::Vector3d normal;  ///< by the order of the corners; zero where it has no area
  double distance;         ///< of the plane, along the normal

  FacingTriangle(const Triangle& triangle, const Eigen::Vector3d& origin, const Eigen::Vector3d& unit_normal)
      : corners{triangle.a - origin, triangle.b - origin, triangle.c - origin},
        normal(unit_normal),
        distance(unit_normal.dot(corners[0])) {}

  /// Returns the normal that points away from the origin.
  [[nodiscard]] Eigen::Vector3d away() const { return distance < 0 ? Eigen::Vector3d(-normal) : normal; }

  [[nodiscard]] bool has_corner_at_origin() const {
    return std::ranges::any_of(corners, [](const Eigen::Vector3d& corner) { return corner.squaredNorm() < at_sample; });
  }

  /// Returns true if a point of the plane is inside the triangle.
  [[nodiscard]] bool contains(const Eigen::Vector3d& q) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d side = corners[(k + 1) % 3] - corners[k];
      if (side.cross(q - corners[k]).dot(normal) < 0) return false;
    }
    return true;
  }
};

/// Returns touching_ball_radius() if it is below the limit, otherwise any value that is not.
double radius_to(const FacingTriangle& triangle, const Eigen::Vector3d& inward, double limit) {
  if (!triangle.normal.isZero(0)) {
    const Eigen::Vector3d away = triangle.away();
    const double radius = std::abs(triangle.distance) / (1 + away.dot(inward));
    // With a margin for rounding: the minimum must not depend on the order of the triangles.
    if (!(radius < limit * (1 + 1e-12))) return infinity;
    const Eigen::Vector3d contact = radius * (inward + away);
    if (contact.squaredNorm() > at_sample && triangle.contains(contact)) return radius;
  }
  double least = infinity;
  for (std::size_t k = 0; k < 3; ++k) {
    least = std::min(least, radius_to_segment(triangle.corners[k], triangle.corners[(k + 1) % 3], inward));
  }
  return least;
}

/// Upper bound of the radius of a ball inside a closed shape of diagonal 1.
constexpr double largest_radius = 0.5;

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

}  // namespace

std::optional<double> touching_ball_radius(const Triangle& triangle, const Eigen::Vector3d& normal) {
  const FacingTriangle facing(triangle, Eigen::Vector3d::Zero(), normal_of(triangle));
  const double radius = facing.has_corner_at_origin() ? infinity : radius_to(facing, normal, infinity);
  return radius < infinity ? std::optional(radius) : std::nullopt;
}

Eigen::VectorXd inscribed_ball(const Shape& shape, const Samples& samples, const InscribedBallOptions& options) {
  check(shape, samples, options);
  const UnitFrame frame = unit_frame(shape);
  const TriangleBVH tree(in_unit_frame(shape, frame));
  std::vector<Eigen::Vector3d> normals;  // of the triangles
  for (std::int32_t i = 0; i < shape.triangles.rows(); ++i) normals.push_back(normal_of(tree.triangle(i)));
  const double most_cosine = std::cos(options.separation_angle_degrees / 180 * std::numbers::pi);
  const auto radius_at = [&](const Eigen::Vector3d& point, const Eigen::Vector3d& inward, std::int32_t index,
                             double limit) {
    const Triangle& triangle = tree.triangle(index);
    if (is_cloud(shape)) {
      const bool separate = -inward.dot(shape.normals.row(index).transpose()) <= most_cosine;
      return separate ? radius_through(triangle.a - point, inward) : infinity;
    }
    const Eigen::Vector3d& normal = normals[static_cast<std::size_t>(index)];
    if (normal.isZero(0)) return infinity;
    const FacingTriangle facing(triangle, point, normal);
    const bool separate = -inward.dot(facing.away()) <= most_cosine;
    return separate && !facing.has_corner_at_origin() ? radius_to(facing, inward, limit) : infinity;
  };
  // `hint` is a triangle that probably stops the ball, replaced by the one that does. It saves time and changes no
  // value.
  const auto diameter_at = [&](Eigen::Index i, std::int32_t& hint) {
    const Eigen::Vector3d inward = -samples.normals.row(i).transpose();
    if (inward.isZero(0)) return std::numeric_limits<double>::quiet_NaN();
    const Eigen::Vector3d point = frame.to_unit(samples.points.row(i).transpose());
    const auto ball_of = [&](double radius) { return Ball{.centre = point + radius * inward, .radius = radius}; };
    const auto shrink = [&](std::int32_t index, Ball& now) {
      const double radius = radius_at(point, inward, index, now.radius);
      if (!(radius < now.radius)) return;
      now = ball_of(radius);
      hint = index;
    };
    Ball ball = ball_of(largest_radius);
    if (hint >= 0) shrink(hint, ball);
    ball = tree.shrunk_ball(ball, shrink);
    return ball.radius < largest_radius ? 2 * ball.radius * frame.diagonal : std::numeric_limits<double>::quiet_NaN();
  };
  Eigen::VectorXd diameters(samples.points.rows());
  const std::vector<std::int32_t> order = morton_order(samples.points);
  const auto answer = [&](const tbb::blocked_range<Eigen::Index>& range) {
    std::int32_t hint = -1;
    for (Eigen::Index k = range.begin(); k < range.end(); ++k) {
      check_interruption();
      const Eigen::Index i = order[static_cast<std::size_t>(k)];
      diameters[i] = diameter_at(i, hint);
    }
  };
  const tbb::blocked_range<Eigen::Index> all(0, samples.points.rows(), 256);
  if (options.parallel) {
    parallel_for_parts(all, answer);
  } else {
    answer(all);
  }
  return diameters;
}

}  // namespace shapegauge
