#include "shapegauge/core/shape/shape.h"

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

Eigen::VectorXd triangle_areas(const Shape& shape) {
  Eigen::VectorXd areas(shape.triangles.rows());
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const Eigen::Vector3d a = shape.vertices.row(shape.triangles(f, 0));
    const Eigen::Vector3d b = shape.vertices.row(shape.triangles(f, 1));
    const Eigen::Vector3d c = shape.vertices.row(shape.triangles(f, 2));
    areas[f] = 0.5 * (b - a).cross(c - a).norm();
  }
  return areas;
}

double surface_area(const Shape& shape) { return triangle_areas(shape).sum(); }

}  // namespace shapegauge
