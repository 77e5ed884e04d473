#include "tests/oracle/rounded_triangle.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace shapegauge {

namespace {

constexpr double never = -1;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The stretch of a ray inside a convex body, as it is cut down by one bound after another.
struct Stretch {
  double enter = -infinity;
  double leave = infinity;

  /// Keeps where offset + slope * t <= 0.
  void keep_below(double offset, double slope) {
    if (slope > 0) {
      leave = std::min(leave, -offset / slope);
    } else if (slope < 0) {
      enter = std::max(enter, -offset / slope);
    } else if (offset > 0) {
      leave = -infinity;
    }
  }

  [[nodiscard]] double exit() const { return enter <= leave ? leave : never; }
};

/// Exit from |m + t d|^2 <= radius^2 where d need not have length 1.
Stretch inside_quadric(const Eigen::Vector3d& m, const Eigen::Vector3d& d, double radius) {
  const double a = d.squaredNorm();
  const double b = m.dot(d);
  const double c = m.squaredNorm() - radius * radius;
  if (!(a > 0)) return c <= 0 ? Stretch{} : Stretch{infinity, -infinity};
  const double discriminant = b * b - a * c;
  if (discriminant < 0) return {infinity, -infinity};
  const double root = std::sqrt(discriminant);
  return {(-b - root) / a, (-b + root) / a};
}

double exit_from_ball(const Eigen::Vector3d& centre, double radius, const Eigen::Vector3d& origin,
                      const Eigen::Vector3d& direction) {
  return inside_quadric(origin - centre, direction, radius).exit();
}

double exit_from_cylinder(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius,
                          const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
  const double length = (b - a).norm();
  if (!(length > 0)) return never;
  const Eigen::Vector3d axis = (b - a) / length;
  const Eigen::Vector3d m = origin - a;
  const double along = m.dot(axis);
  const double slope = direction.dot(axis);
  Stretch stretch = inside_quadric(m - along * axis, direction - slope * axis, radius);
  stretch.keep_below(-along, -slope);
  stretch.keep_below(along - length, slope);
  return stretch.exit();
}

double exit_from_prism(const Triangle& triangle, double radius, const Eigen::Vector3d& origin,
                       const Eigen::Vector3d& direction) {
  const Eigen::Vector3d cross = (triangle.b - triangle.a).cross(triangle.c - triangle.a);
  const double length = cross.norm();
  if (!(length > 0)) return never;
  const Eigen::Vector3d normal = cross / length;
  Stretch stretch;
  const double height = (origin - triangle.a).dot(normal);
  const double slope = direction.dot(normal);
  stretch.keep_below(height - radius, slope);
  stretch.keep_below(-height - radius, -slope);
  const auto keep_inside_edge = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const Eigen::Vector3d outward = (to - from).cross(normal);
    stretch.keep_below((origin - from).dot(outward), direction.dot(outward));
  };
  keep_inside_edge(triangle.a, triangle.b);
  keep_inside_edge(triangle.b, triangle.c);
  keep_inside_edge(triangle.c, triangle.a);
  return stretch.exit();
}

}  // namespace

double exit_from_rounded_triangle(const Triangle& triangle, double radius, const Eigen::Vector3d& origin,
                                  const Eigen::Vector3d& direction) {
  const auto& [a, b, c] = triangle;
  return std::max({exit_from_ball(a, radius, origin, direction), exit_from_ball(b, radius, origin, direction),
                   exit_from_ball(c, radius, origin, direction), exit_from_cylinder(a, b, radius, origin, direction),
                   exit_from_cylinder(b, c, radius, origin, direction),
                   exit_from_cylinder(c, a, radius, origin, direction),
                   exit_from_prism(triangle, radius, origin, direction)});
}

}  // namespace shapegauge
