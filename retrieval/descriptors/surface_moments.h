// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Moments of a mesh's surface, integrated over its triangles.
struct SurfaceMoments {
  double area = 0;                                       ///< area of the surface
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();    ///< centroid of the surface
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< covariance of the surface's points about the centroid
  Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();  ///< mean of n n^T over the surface; n: unit normal of either sign
};

/// Computes the moments of a mesh's surface; all zero for a mesh without area.
SurfaceMoments surface_moments(const Shape& mesh);

/// Returns the eigenvectors of a symmetric matrix as rows of a rotation, by decreasing eigenvalue.
Eigen::Matrix3d principal_axes(const Eigen::Matrix3d& symmetric);

}  // namespace shapegauge
