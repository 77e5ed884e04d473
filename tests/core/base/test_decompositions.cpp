// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shapegauge/core/base/decompositions.h"

namespace shapegauge {
namespace {

TEST(RotationBetween, MapsOneDirectionToAnother) {
  const Eigen::Vector3d from(2, -1, 0.5);
  for (const Eigen::Vector3d& to : {Eigen::Vector3d(0, 0, 3), Eigen::Vector3d(1, 4, -2), Eigen::Vector3d(-from)}) {
    const Eigen::Matrix3d rotation = rotation_between(from, to);
    EXPECT_TRUE((rotation * from.normalized()).isApprox(to.normalized(), 1e-12)) << to.transpose();
    EXPECT_TRUE((rotation * rotation.transpose()).isIdentity(1e-12)) << to.transpose();
    EXPECT_NEAR(rotation.determinant(), 1, 1e-12) << to.transpose();
  }
}

TEST(EigenDecomposition, ListsEigenvaluesOfASymmetricMatrixInAscendingOrder) {
  const Eigen::Matrix3d matrix{{2, 1, 0}, {1, 2, 0}, {0, 0, 5}};  // eigenvalues 1, 3, 5
  const Eigen::Vector3d values(1, 3, 5);
  const auto small = eigen_decomposition(matrix);
  EXPECT_TRUE(small.eigenvalues().isApprox(values, 1e-12));
  EXPECT_TRUE((matrix * small.eigenvectors()).isApprox(small.eigenvectors() * values.asDiagonal(), 1e-12));
  const auto large = eigen_decomposition(Eigen::MatrixXd(matrix));
  EXPECT_TRUE(large.eigenvalues().isApprox(values, 1e-12));
  EXPECT_TRUE((matrix * large.eigenvectors()).isApprox(large.eigenvectors() * values.asDiagonal(), 1e-12));
}

}  // namespace
}  // namespace shapegauge
