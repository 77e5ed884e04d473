// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/shape/shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <fmt/format.h>
#include <limits>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/shape/connectivity.h"

namespace shapegauge {

Eigen::AlignedBox3d bounding_box(const Shape& shape) {
  Eigen::AlignedBox3d box;
  if (is_cloud(shape)) {
    for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) box.extend(shape.vertices.row(i).transpose());
    return box;
  }
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) box.extend(shape.vertices.row(shape.triangles(f, k)).transpose());
  }
  return box;
}

double bounding_box_diagonal(const Shape& shape) {
  const Eigen::AlignedBox3d box = bounding_box(shape);
  return box.isEmpty() ? 0 : box.sizes().stableNorm();
}

namespace {

double triangle_area(const Shape& shape, Eigen::Index triangle) {
  const Eigen::Vector3d a = shape.vertices.row(shape.triangles(triangle, 0));
  const Eigen::Vector3d b = shape.vertices.row(shape.triangles(triangle, 1));
  const Eigen::Vector3d c = shape.vertices.row(shape.triangles(triangle, 2));
  return 0.5 * (b - a).cross(c - a).norm();
}

}  // namespace

Eigen::VectorXd triangle_areas(const Shape& shape) {
  Eigen::VectorXd areas(shape.triangles.rows());
  for (Eigen::Index f = 0; f < areas.size(); ++f) areas[f] = triangle_area(shape, f);
  return areas;
}

bool is_degenerate(const Shape& mesh, Eigen::Index triangle) {
  const Eigen::Vector3d a = mesh.vertices.row(mesh.triangles(triangle, 0));
  const Eigen::Vector3d b = mesh.vertices.row(mesh.triangles(triangle, 1));
  const Eigen::Vector3d c = mesh.vertices.row(mesh.triangles(triangle, 2));
  const double unit = std::max((b - a).cwiseAbs().maxCoeff(), (c - a).cwiseAbs().maxCoeff());
  if (!(unit > 0)) return true;
  const double largest = std::max({a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff(), c.cwiseAbs().maxCoeff()});
  // Coordinates rounded to double move each corner by up to an epsilon of their size.
  const double tolerance = 4 * std::numeric_limits<double>::epsilon() * (largest / unit);
  return ((b - a) / unit).cross((c - a) / unit).norm() <= tolerance;
}

Eigen::RowVector3d triangle_normal(const Shape& mesh, Eigen::Index triangle) {
  const Eigen::Vector3d a = mesh.vertices.row(mesh.triangles(triangle, 0));
  const Eigen::Vector3d b = mesh.vertices.row(mesh.triangles(triangle, 1));
  const Eigen::Vector3d c = mesh.vertices.row(mesh.triangles(triangle, 2));
  const Eigen::RowVector3d normal = (b - a).cross(c - a).stableNormalized().transpose();
  return normal.allFinite() ? normal : Eigen::RowVector3d::Zero();
}

double surface_area(const Shape& shape) { return is_cloud(shape) ? 0 : surface_area(shape, welding_of(shape)); }

double surface_area(const Shape& shape, const Welding& welding) {
  Eigen::VectorXd areas(shape.triangles.rows());
  Eigen::Index count = 0;
  for (Eigen::Index f = 0; f < areas.size(); ++f) {
    if (welding.is_distinct(f)) areas[count++] = triangle_area(shape, f);
  }
  return areas.head(count).sum();
}

std::vector<bool> used_vertices(const Shape& shape) {
  std::vector<bool> used(static_cast<std::size_t>(shape.vertices.rows()));
  for (const std::int32_t vertex : shape.triangles.reshaped()) used[static_cast<std::size_t>(vertex)] = true;
  return used;
}

std::optional<std::string> find_defect(const Shape& shape) {
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) {
    if (!shape.vertices.row(i).allFinite()) {
      return fmt::format("vertex {} has a coordinate that is not a finite number", i);
    }
  }
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const auto triangle = shape.triangles.row(f);
    if (triangle.minCoeff() < 0 || triangle.maxCoeff() >= shape.vertices.rows()) {
      return fmt::format("triangle {} has a vertex outside 0..{}", f, shape.vertices.rows() - 1);
    }
  }
  return std::nullopt;
}

void require_usable(const Shape& shape) {
  if (const auto defect = find_defect(shape)) throw InputError(fmt::format("the shape is unusable: {}", *defect));
}

UnitFrame unit_frame(const Shape& shape) {
  const Eigen::AlignedBox3d box = bounding_box(shape);
  if (box.isEmpty()) return {};
  // Halving first avoids overflow of the largest coordinates.
  const Eigen::Vector3d centre = box.min() / 2 + box.max() / 2;
  const double diagonal = box.sizes().stableNorm();
  return {centre, diagonal > 0 ? diagonal : 1};
}

Shape in_unit_frame(const Shape& shape, const UnitFrame& frame) {
  Shape result{shape.vertices, shape.triangles};
  for (Eigen::Index i = 0; i < result.vertices.rows(); ++i) {
    result.vertices.row(i) = frame.to_unit(shape.vertices.row(i).transpose()).transpose();
  }
  return result;
}

}  // namespace shapegauge
