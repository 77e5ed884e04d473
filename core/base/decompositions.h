// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Eigenvalues>

/// Functions on Eigen's decompositions, compiled only once because each takes a compiler several seconds.
namespace shapegauge {

/// Returns the matrix of the rotation by the smallest angle from the direction of `from` to that of `to` (both
/// non-zero).
Eigen::Matrix3d rotation_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Returns the eigenvalues, in ascending order, and eigenvectors of a symmetric matrix.
Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen_decomposition(const Eigen::Matrix3d& symmetric);

/// Returns the eigenvalues, in ascending order, of a symmetric matrix of any size, and its eigenvectors unless
/// `options` is Eigen::EigenvaluesOnly.
Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen_decomposition(const Eigen::MatrixXd& symmetric,
                                                                   int options = Eigen::ComputeEigenvectors);

}  // namespace shapegauge
