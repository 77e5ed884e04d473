// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/base/decompositions.h"

#include <Eigen/Geometry>

namespace shapegauge {

Eigen::Matrix3d rotation_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
}

Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen_decomposition(const Eigen::Matrix3d& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(symmetric);
}

Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen_decomposition(const Eigen::MatrixXd& symmetric, int options) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, options);
}

}  // namespace shapegauge
