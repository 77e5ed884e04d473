// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/descriptors/surface_moments.h"

#include <Eigen/Geometry>

#include "shapegauge/core/base/decompositions.h"

namespace shapegauge {

SurfaceMoments surface_moments(const Shape& mesh) {
  SurfaceMoments moments;
  if (mesh.triangles.rows() == 0) return moments;
  // A nearby origin preserves the digits of squared coordinates.
  const Eigen::Vector3d origin = bounding_box(mesh).center();
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) corners.col(k) = mesh.vertices.row(mesh.triangles(f, k)).transpose() - origin;
    const Eigen::Vector3d cross = (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
    const double twice_area = cross.norm();
    if (!(twice_area > 0)) continue;
    const Eigen::Vector3d sum = corners.rowwise().sum();
    moments.area += twice_area / 2;
    moments.centroid += twice_area / 6 * sum;
    moments.covariance += twice_area / 24 * (corners * corners.transpose() + sum * sum.transpose());
    moments.normals += cross * cross.transpose() / (2 * twice_area);
  }
  if (!(moments.area > 0)) return moments;
  moments.centroid /= moments.area;
  moments.covariance = moments.covariance / moments.area - moments.centroid * moments.centroid.transpose();
  moments.normals /= moments.area;
  moments.centroid += origin;
  return moments;
}

Eigen::Matrix3d principal_axes(const Eigen::Matrix3d& symmetric) {
  const auto solver = eigen_decomposition(symmetric);
  Eigen::Matrix3d axes;
  axes.row(0) = solver.eigenvectors().col(2).transpose();
  axes.row(1) = solver.eigenvectors().col(1).transpose();
  axes.row(2) = axes.row(0).cross(axes.row(1));
  return axes;
}

}  // namespace shapegauge
