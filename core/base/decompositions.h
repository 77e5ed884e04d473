// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Eigenvalues>

/// Decompositions of Eigen that take a compiler several seconds, compiled once.
namespace shapegauge {

/// Returns the shortest rotation from one direction to another.
Eigen::Matrix3d rotation_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Returns the eigenvalues, in ascending order, and eigenvectors of a symmetric matrix.
Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen_decomposition(const Eigen::Matrix3d& symmetric);

/// The same for any size; `options`: with eigenvectors, or Eigen::EigenvaluesOnly.
Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen_decomposition(const Eigen::MatrixXd& symmetric,
                                                                   int options = Eigen::ComputeEigenvectors);

}  // namespace shapegauge
