#include "shapegauge/core/fields/touching_ball.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace shapegauge {

namespace {

/// Radius of a ball that touches nothing.
constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Returns the touching radius of a segment: of the point where the ball touches its line, or of its first end; the
/// other end belongs to the next segment.
double radius_to_segment(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& normal,
                         double rounding) {
  const double at_end = touching_radius(from, normal, rounding);
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
  if (!(along > 0 && along < length)) return at_end;
  return std::min(at_end, touching_radius(from + along * direction, normal, rounding));
}

}  // namespace

Eigen::Vector3d oriented_normal(const Triangle& triangle) {
  const Eigen::Vector3d area = (triangle.b - triangle.a).cross(triangle.c - triangle.a);
  const double size = area.norm();
  return size > 0 ? Eigen::Vector3d(area / size) : Eigen::Vector3d::Zero();
}

bool FacingTriangle::has_corner_at_origin() const {
  return std::ranges::any_of(corners, [&](const Eigen::Vector3d& corner) { return corner.norm() < rounding; });
}

bool FacingTriangle::contains(const Eigen::Vector3d& q) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d side = corners[(k + 1) % 3] - corners[k];
    if (side.cross(q - corners[k]).dot(normal) < 0) return false;
  }
  return true;
}

double touching_radius(const Eigen::Vector3d& q, const Eigen::Vector3d& normal, double rounding) {
  const double height = q.dot(normal);
  const double square = q.squaredNorm();
  return height > 0 && square > rounding * rounding ? square / (2 * height) : unlimited;
}

double touching_radius(const FacingTriangle& triangle, const Eigen::Vector3d& normal, double limit) {
  if (triangle.has_corner_at_origin()) return unlimited;
  if (!triangle.normal.isZero(0)) {
    const Eigen::Vector3d away = triangle.away();
    const double radius = std::abs(triangle.distance) / (1 + away.dot(normal));
    // With a margin for rounding: the minimum must not depend on the order of the triangles.
    if (!(radius < limit * (1 + 1e-12))) return unlimited;
    const Eigen::Vector3d contact = radius * (normal + away);
    if (contact.norm() > triangle.rounding && triangle.contains(contact)) return radius;
  }
  double least = unlimited;
  for (std::size_t k = 0; k < 3; ++k) {
    least = std::min(least,
                     radius_to_segment(triangle.corners[k], triangle.corners[(k + 1) % 3], normal, triangle.rounding));
  }
  return least;
}

}  // namespace shapegauge
