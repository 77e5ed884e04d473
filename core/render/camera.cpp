// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/render/camera.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/render/shading.h"

namespace shapegauge {

namespace {

void check(const RenderOptions& options) {
  constexpr int largest_side = 1 << 15;
  if (options.width < 1 || options.height < 1 || options.width > largest_side || options.height > largest_side ||
      options.rays_per_side < 1 || options.rays_per_side > 16 || !(options.margin >= 0 && options.margin < 0.5)) {
    throw InputError(
        fmt::format("an image of {} x {} pixels with {} rays per side and a margin of {} is out of range; the limits "
                    "are 1 to {}, 1 to 16, and 0 to less than 0.5",
                    options.width, options.height, options.rays_per_side, options.margin, largest_side));
  }
  const double sine = options.up.normalized().cross(options.towards_viewer.normalized()).norm();
  if (!(sine > 1e-6)) throw InputError("the directions to the viewer and up must be finite, not zero and not parallel");
}

/// Calls visit(point, weight) for a quadrature of the surface that is exact up to degree 2: the triangles' corners and
/// centroids. For a cloud, visits its points.
template <typename Visit>
void visit_weighted_points(const Shape& shape, const Visit& visit) {
  for (Eigen::Index i = 0; i < shape.triangles.rows(); ++i) {
    const Eigen::Vector3d a = shape.vertices.row(shape.triangles(i, 0));
    const Eigen::Vector3d b = shape.vertices.row(shape.triangles(i, 1));
    const Eigen::Vector3d c = shape.vertices.row(shape.triangles(i, 2));
    const double area = (b - a).cross(c - a).norm() / 2;
    for (const auto& corner : {a, b, c}) visit(corner, area / 12);
    visit((a + b + c) / 3, area * 3 / 4);
  }
  if (!is_cloud(shape)) return;
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) visit(shape.vertices.row(i).transpose(), 1);
}

/// Computes the second moments of the surface, or of a cloud's points, in a plane; NaN without any.
Eigen::Matrix2d second_moments(const Shape& shape, const Eigen::Matrix<double, 3, 2>& plane) {
  double mass = 0;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  visit_weighted_points(shape, [&](const Eigen::Vector3d& point, double weight) {
    mass += weight;
    centre += weight * plane.transpose() * point;
  });
  centre /= mass;
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  visit_weighted_points(shape, [&](const Eigen::Vector3d& point, double weight) {
    const Eigen::Vector2d arm = plane.transpose() * point - centre;
    second += (weight / mass * arm) * arm.transpose();
  });
  return second;
}

}  // namespace

Camera camera_for(const Shape& shape, const RenderOptions& options) {
  check(options);
  Camera camera;
  camera.forward = -options.towards_viewer.normalized();
  camera.right = camera.forward.cross(options.up).normalized();
  camera.up = camera.right.cross(camera.forward);
  camera.light = (light_up * camera.up + light_right * camera.right - light_towards * camera.forward).normalized();
  Eigen::Matrix3d axes;
  axes << camera.right, camera.up, camera.forward;
  Eigen::AlignedBox3d box;  // in the camera's axes
  for (const std::int32_t v : shape.triangles.reshaped()) box.extend((shape.vertices.row(v) * axes).transpose());
  const double inside = 1 - 2 * options.margin;
  const double depth = box.sizes().norm();
  camera.pixel = std::max({box.sizes().x() / (inside * options.width), box.sizes().y() / (inside * options.height),
                           1e-9 * depth});  // a flat shape seen edge-on still has a picture
  const Eigen::Vector3d centre = box.center();
  camera.top_left = axes * Eigen::Vector3d(centre.x() - camera.pixel * options.width / 2,
                                           centre.y() + camera.pixel * options.height / 2, box.min().z() - depth / 2);
  return camera;
}

Eigen::Vector3d front_of(const Eigen::Vector3d& up) {
  const Eigen::Vector3d unit = up.normalized();
  const Eigen::Vector3d front = std::abs(unit.z()) > 0.5 ? Eigen::Vector3d(0, -1, 0) : Eigen::Vector3d(0, 0, 1);
  return (front - unit.dot(front) * unit).normalized();
}

RenderOptions upright_view(const Shape& shape, RenderOptions options) {
  constexpr double round = 0.05;  // relative difference of moments up to which no side is the broad one
  const Eigen::Vector3d up = options.up.normalized();
  Eigen::Matrix<double, 3, 2> horizontal;
  horizontal << up.cross(front_of(up)), front_of(up);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> principal(second_moments(shape, horizontal));  // ascending
  const Eigen::Vector2d& moments = principal.eigenvalues();
  Eigen::Vector2d towards(0, 1);
  if (moments[1] - moments[0] > round * moments[1]) towards = principal.eigenvectors().col(0);
  if (towards.dot(Eigen::Vector2d(0.6, 1)) < 0) towards = -towards;
  const Eigen::Vector3d broad = horizontal * towards;
  options.towards_viewer = broad + 0.35 * up.cross(broad) + 0.45 * up;
  return options;
}

}  // namespace shapegauge
