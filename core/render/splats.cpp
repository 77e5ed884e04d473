// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/render/splats.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "shapegauge/core/shape/point_cloud.h"

namespace shapegauge {

namespace {

/// Radius of a splat, in radii of the disc with the point's area. For random points in a plane, exp(-2.25^2), or 0.6 %,
/// stays uncovered.
constexpr double overlap = 2.25;

void add_splat(Shape& mesh, Eigen::Index i, const Eigen::Vector3d& centre, const Eigen::Vector3d& normal,
               double radius) {
  constexpr int corners = triangles_per_splat + 2;
  const Eigen::Vector3d u = normal.unitOrthogonal();
  const Eigen::Vector3d v = normal.cross(u);
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    mesh.vertices.row(corners * i + k) = centre + radius * (std::cos(angle) * u + std::sin(angle) * v);
  }
  const auto first = static_cast<std::int32_t>(corners * i);
  for (int k = 0; k < triangles_per_splat; ++k) {
    mesh.triangles.row(triangles_per_splat * i + k) << first, first + k + 1, first + k + 2;
  }
}

}  // namespace

Shape splats(const Shape& cloud) {
  const UnitFrame frame = unit_frame(cloud);
  const Eigen::Index n = cloud.vertices.rows();
  Points points(n, 3);  // in coordinates near 1, whose squares neither vanish nor overflow
  for (Eigen::Index i = 0; i < n; ++i) points.row(i) = frame.to_unit(cloud.vertices.row(i).transpose()).transpose();
  const Eigen::VectorXd weights = point_weights(points);
  const bool has_all_normals = cloud.normals.rows() > 0 && (cloud.normals.array() != 0).rowwise().any().all();
  const Points estimated = has_all_normals ? Points() : unsigned_point_normals(points);
  Shape mesh;
  mesh.vertices.resize((triangles_per_splat + 2) * n, 3);
  mesh.triangles.resize(triangles_per_splat * n, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    if (cloud.normals.rows() > 0) normal = cloud.normals.row(i);
    if (normal.isZero(0)) normal = estimated.row(i);
    if (normal.isZero(0)) normal = Eigen::Vector3d::UnitZ();  // its neighbours coincide with the point
    add_splat(mesh, i, points.row(i), normal, overlap * std::sqrt(weights[i] / std::numbers::pi));
  }
  mesh.vertices = (mesh.vertices * frame.diagonal).rowwise() + frame.centre.transpose();
  return mesh;
}

}  // namespace shapegauge
