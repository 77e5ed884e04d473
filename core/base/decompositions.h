// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Eigenvalues>

/// Functions on Eigen's decompositions, compiled only once because each takes a compiler several seconds.
namespace shapegauge {

/// Returns the matrix of the rotation by the smallest angle that turns `from` into the direction of `to`.
Eigen::Matrix3d rotation_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Returns the eigenvalues, in ascending order, and eigenvectors of a symmetric matrix.
Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen_decomposition(const Eigen::Matrix3d& symmetric);

/// The same for any size; `options`: with eigenvectors, or Eigen::EigenvaluesOnly.
Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen_decomposition(const Eigen::MatrixXd& symmetric,
                                                                   int options = Eigen::ComputeEigenvectors);

}  // namespace shapegauge
