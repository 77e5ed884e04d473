// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/descriptors/surface_mesh.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>

#include "shapegauge/core/shape/distinct_triangles.h"
#include "shapegauge/core/shape/samples.h"

namespace shapegauge {

Shape surface_mesh(const Shape& shape) {
  require_usable(shape);
  if (!is_cloud(shape)) return without_duplicates(shape);
  const Samples samples = sample_shape(shape, SampleSite::vertices);
  Shape result{Points(4 * samples.points.rows(), 3), Triangles(2 * samples.points.rows(), 3)};
  std::int32_t vertices = 0;
  Eigen::Index triangles = 0;
  for (Eigen::Index i = 0; i < samples.points.rows(); ++i) {
    const Eigen::Vector3d normal = samples.normals.row(i).transpose();
    if (!(samples.weights[i] > 0) || normal.isZero(0)) continue;
    const double half_side = std::sqrt(samples.weights[i]);
    const Eigen::RowVector3d a = half_side * normal.unitOrthogonal().transpose();
    const Eigen::RowVector3d b = half_side * normal.cross(normal.unitOrthogonal()).transpose();
    const Eigen::RowVector3d centre = samples.points.row(i);
    result.vertices.middleRows<4>(vertices) << centre + a + b, centre - a + b, centre - a - b, centre + a - b;
    result.triangles.middleRows<2>(triangles) << vertices, vertices + 1, vertices + 2, vertices, vertices + 2,
        vertices + 3;
    vertices += 4;
    triangles += 2;
  }
  result.vertices.conservativeResize(vertices, 3);
  result.triangles.conservativeResize(triangles, 3);
  return result;
}

}  // namespace shapegauge
