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

/// Skewness (third moment divided by the cubed standard deviation) below which an axis counts as balanced: rounding
/// must not determine the view.
constexpr double balanced_skewness = 1e-3;

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

/// Returns the axis or its opposite.
Eigen::Vector3d pointed(const Eigen::Vector3d& axis, double variance, double third_moment) {
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  const bool balanced = std::abs(third_moment) <= balanced_skewness * std::pow(variance, 1.5);
  return (balanced ? axis[largest] : third_moment) < 0 ? Eigen::Vector3d(-axis) : axis;
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

RenderOptions principal_view(const Shape& shape, RenderOptions options) {
  double mass = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  visit_weighted_points(shape, [&](const Eigen::Vector3d& point, double weight) {
    mass += weight;
    centre += weight * point;
  });
  if (!(mass > 0) || !std::isfinite(mass) || !centre.allFinite()) return options;
  centre /= mass;
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  visit_weighted_points(shape, [&](const Eigen::Vector3d& point, double weight) {
    const Eigen::Vector3d arm = point - centre;
    second += (weight / mass * arm) * arm.transpose();
  });
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(second);  // ascending
  const Eigen::Matrix3d to_axes = principal.eigenvectors().transpose();
  Eigen::Vector3d third = Eigen::Vector3d::Zero();
  visit_weighted_points(shape, [&](const Eigen::Vector3d& point, double weight) {
    const Eigen::Array3d along = to_axes * (point - centre);
    third += (weight / mass * along * along * along).matrix();
  });
  Eigen::Matrix3d axes;
  for (int k = 0; k < 3; ++k)
    axes.col(k) = pointed(principal.eigenvectors().col(k), principal.eigenvalues()[k], third[k]);
  options.up = axes.col(1);
  options.towards_viewer = axes.col(0) + 0.35 * axes.col(2) + 0.45 * axes.col(1);
  return options;
}

}  // namespace shapegauge
