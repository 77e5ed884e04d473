// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/preparation/stray_normals.h"

#include <cmath>

#include "shapegauge/core/shape/point_cloud.h"

namespace shapegauge {

bool has_stray_normals(const Shape& shape) {
  constexpr double cosine_of_60_degrees = 0.5;
  constexpr double max_stray = 0.25;
  constexpr double min_agreement = 0.8;
  if (!is_cloud(shape) || shape.normals.rows() == 0 || shape.vertices.rows() < 2) return false;
  const Points estimated = unsigned_point_normals(shape.vertices);
  const PointNeighbours nearest = nearest_neighbours(shape.vertices, 1);
  double agreement = 0;
  double stray = 0;
  double known = 0;  // zero normals are unknown
  for (Eigen::Index i = 0; i < estimated.rows(); ++i) {
    agreement += std::abs(estimated.row(i).dot(estimated.row(nearest.indices(i, 0))));
    const double length = shape.normals.row(i).stableNorm();
    if (!(length > 0)) continue;
    known += 1;
    stray += std::abs(estimated.row(i).dot(shape.normals.row(i))) < cosine_of_60_degrees * length ? 1 : 0;
  }
  return agreement >= min_agreement * static_cast<double>(estimated.rows()) && stray > max_stray * known;
}

bool remove_stray_normals(Shape& shape) {
  if (!has_stray_normals(shape)) return false;
  shape.normals.resize(0, 3);
  return true;
}

}  // namespace shapegauge
