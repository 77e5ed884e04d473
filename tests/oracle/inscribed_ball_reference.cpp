// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracle/inscribed_ball_reference.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "shapegauge/core/spatial/closest_point.h"

namespace shapegauge::test {

namespace {

/// Search for the smallest ball through an opposite point, by division of triangles.
struct Reference {
  Eigen::Vector3d point;
  Eigen::Vector3d direction;
  double separation_angle;
  double rounding;
  double radius;  ///< smallest found

  void try_point(const Eigen::Vector3d& q) {
    const double height = (q - point).dot(direction);
    if (!(height > 0 && (q - point).norm() > rounding)) return;
    const double touching = (q - point).squaredNorm() / (2 * height);
    const Eigen::Vector3d centre = point + touching * direction;
    const double cosine = (point - centre).normalized().dot((q - centre).normalized());
    if (std::acos(std::clamp(cosine, -1.0, 1.0)) >= separation_angle - 1e-7) radius = std::min(radius, touching);
  }

  /// Returns true if a part of the triangle may contain opposite points within a ball of nearly the smallest radius.
  [[nodiscard]] bool may_stop(const Triangle& triangle) const {
    const Eigen::Vector3d middle = (triangle.a + triangle.b + triangle.c) / 3;
    const double extent =
        std::max({(triangle.a - middle).norm(), (triangle.b - middle).norm(), (triangle.c - middle).norm()});
    const double distance = (middle - point).norm();
    if (distance > extent) {
      const double angle = std::acos(std::clamp((middle - point).dot(direction) / distance, -1.0, 1.0));
      if (angle - std::asin(extent / distance) > (std::numbers::pi - separation_angle) / 2) return false;
    }
    const double smaller = (1 - 1e-5) * radius;
    const Eigen::Vector3d centre = point + smaller * direction;
    return (closest_point(triangle, centre) - centre).norm() < smaller;
  }

  void search(const Triangle& triangle) {  // NOLINT(misc-no-recursion)
    if (!may_stop(triangle)) return;
    const Eigen::Vector3d ab = (triangle.a + triangle.b) / 2;
    const Eigen::Vector3d bc = (triangle.b + triangle.c) / 2;
    const Eigen::Vector3d ca = (triangle.c + triangle.a) / 2;
    for (const Eigen::Vector3d& q : {triangle.a, triangle.b, triangle.c, ab, bc, ca}) try_point(q);
    const double size = std::max({(ab - bc).norm(), (bc - ca).norm(), (ca - ab).norm()});
    if (size < 1e-5 * radius) return;
    for (const Triangle& part : {Triangle{ab, bc, ca}, Triangle{triangle.a, ab, ca}, Triangle{ab, triangle.b, bc},
                                 Triangle{ca, bc, triangle.c}}) {
      search(part);
    }
  }
};

}  // namespace

double touching_ball_by_definition(const Shape& mesh, const Eigen::Vector3d& point, const Eigen::Vector3d& direction,
                                   double separation_angle_degrees) {
  const double largest = bounding_box_diagonal(mesh) / 2;
  Reference reference{point, direction, separation_angle_degrees / 180 * std::numbers::pi, 2e-9 * largest, largest};
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    const auto corner = [&](int k) -> Eigen::Vector3d { return mesh.vertices.row(mesh.triangles(f, k)); };
    const Triangle triangle{corner(0), corner(1), corner(2)};
    const bool at_corner = std::min({(triangle.a - point).norm(), (triangle.b - point).norm(),
                                     (triangle.c - point).norm()}) < reference.rounding;
    Eigen::Vector3d away = (triangle.b - triangle.a).cross(triangle.c - triangle.a);
    if (at_corner || away.isZero(0)) continue;
    if (away.dot(triangle.a - point) < 0) away = -away;
    const double cosine = std::clamp(-away.normalized().dot(direction), -1.0, 1.0);
    if (std::acos(cosine) >= reference.separation_angle - 1e-7) reference.search(triangle);
  }
  return reference.radius < largest ? 2 * reference.radius : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace shapegauge::test
