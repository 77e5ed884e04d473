// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/fields/touching_ball.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace shapegauge {

namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

/// Radius of a ball that touches nothing.
constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Margin of cosines for angles that are exactly the largest.
constexpr double cosine_margin = 1e-9;

/// Returns true if a point of the triangle's plane is inside the triangle.
bool contains(const Corners& corners, const Eigen::Vector3d& normal, const Eigen::Vector3d& q) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d side = corners[(k + 1) % 3] - corners[k];
    if (side.cross(q - corners[k]).dot(normal) < 0) return false;
  }
  return true;
}

/// Returns the position, along a unit direction from a point, at which the smallest touching ball meets the line;
/// infinity if the line does not come nearer than its far end.
double contact_along(const Eigen::Vector3d& from, const Eigen::Vector3d& line, const Eigen::Vector3d& direction) {
  const double from_along = from.dot(line);
  const double slope = direction.dot(line);
  // The distance from the ball's centre to the line is its radius r: slope^2 r^2 + 2 b r = a.
  const double a = from.squaredNorm() - from_along * from_along;
  const double b = from.dot(direction) - from_along * slope;
  const double root = b + std::sqrt(std::max(0.0, b * b + slope * slope * a));
  return root > 0 ? a / root * slope - from_along : unlimited;
}

/// Returns the touching radius of a segment: of the point where the ball touches its line, of the nearer end, or, if
/// that is outside the cone, of a point where the segment enters the cone.
double radius_to_segment(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const OppositePoints& opposite) {
  const double length = (to - from).norm();
  if (!(length > 0)) return touching_radius(from, opposite);  // by rounding: the corners are relative to the origin
  const Eigen::Vector3d line = (to - from) / length;
  const double contact = contact_along(from, line, opposite.direction);
  double least = unlimited;
  const auto try_at = [&](double along) {
    if (along >= 0 && along <= length) least = std::min(least, touching_radius(from + along * line, opposite));
  };
  if (contact < unlimited) try_at(std::clamp(contact, 0.0, length));
  if (least < unlimited) return least;
  try_at(0);
  try_at(length);
  // On the cone: (h + s t)^2 = c^2 |from + t line|^2.
  const double height = from.dot(opposite.direction);
  const double slope = line.dot(opposite.direction);
  const double square = opposite.cone_cosine * opposite.cone_cosine;
  const double a = slope * slope - square;
  const double b = height * slope - square * from.dot(line);
  const double c = height * height - square * from.squaredNorm();
  const double discriminant = b * b - a * c;
  if (!(discriminant >= 0)) return least;
  const double sum = -(b + std::copysign(std::sqrt(discriminant), b));  // a may be 0: the line is parallel to the cone
  try_at(sum / a);
  try_at(c / sum);
  return least;
}

}  // namespace

Eigen::Vector3d oriented_normal(const Triangle& triangle) {
  const Eigen::Vector3d area = (triangle.b - triangle.a).cross(triangle.c - triangle.a);
  const double size = area.norm();
  return size > 0 ? Eigen::Vector3d(area / size) : Eigen::Vector3d::Zero();
}

double touching_radius(const Eigen::Vector3d& q, const OppositePoints& opposite) {
  const double height = q.dot(opposite.direction);
  const double square = q.squaredNorm();
  if (!(square > opposite.rounding * opposite.rounding && height > 0)) return unlimited;
  return height >= (opposite.cone_cosine - cosine_margin) * std::sqrt(square) ? square / (2 * height) : unlimited;
}

double touching_radius(const Triangle& triangle, const Eigen::Vector3d& normal, const OppositePoints& opposite,
                       double limit) {
  if (normal.isZero(0)) return unlimited;
  const Corners corners{triangle.a, triangle.b, triangle.c};
  const double distance = normal.dot(triangle.a);
  const double cosine = (distance < 0 ? -1 : 1) * normal.dot(opposite.direction);
  if (cosine < opposite.min_cosine - cosine_margin) return unlimited;
  const double radius = std::abs(distance) / (1 + cosine);
  // With a margin for rounding: the minimum must not depend on the order of the triangles.
  if (!(radius < limit * (1 + 1e-12))) return unlimited;
  const Eigen::Vector3d away = distance < 0 ? Eigen::Vector3d(-normal) : normal;
  const Eigen::Vector3d contact = radius * (opposite.direction + away);
  if (contact.norm() > opposite.rounding && contains(corners, normal, contact)) return radius;
  const auto at_origin = [&](const Eigen::Vector3d& corner) { return corner.norm() < opposite.rounding; };
  if (std::ranges::any_of(corners, at_origin)) return unlimited;
  double least = unlimited;
  for (std::size_t k = 0; k < 3; ++k) {
    least = std::min(least, radius_to_segment(corners[k], corners[(k + 1) % 3], opposite));
  }
  return least;
}

}  // namespace shapegauge
