// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shapegauge/retrieval/descriptors/surface_moments.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

TEST(SurfaceMoments, OfABoxMatchIntegralsOverItsSides) {
  const Eigen::Vector3d size(1, 2, 4);
  const Eigen::Vector3d move(10, 20, 30);
  const SurfaceMoments found =
      surface_moments(test::transformed(test::box(size, 3), 1, Eigen::Matrix3d::Identity(), move));
  EXPECT_NEAR(found.area, 28, 1e-12);
  EXPECT_LT((found.centroid - move).norm(), 1e-12);
  const Eigen::Vector3d side(8, 4, 2);  // area across each axis, of one of two sides
  for (int k = 0; k < 3; ++k) {
    const double along = (2 * side[k] * size[k] * size[k] / 4 + (28 - 2 * side[k]) * size[k] * size[k] / 12) / 28;
    EXPECT_NEAR(found.covariance(k, k), along, 1e-12) << k;
    EXPECT_NEAR(found.normals(k, k), 2 * side[k] / 28, 1e-12) << k;
  }
  EXPECT_LT((found.covariance - Eigen::Matrix3d(found.covariance.diagonal().asDiagonal())).norm(), 1e-12);
}

TEST(SurfaceMoments, AreZeroForShapesWithoutArea) {
  EXPECT_EQ(surface_moments(Shape{}).area, 0);
  EXPECT_EQ(surface_moments(Shape{Points::Zero(3, 3), Triangles{{0, 1, 2}}}).covariance.norm(), 0);
}

TEST(PrincipalAxes, AreARotationSortedByDescendingEigenvalue) {
  const Eigen::Matrix3d turn = test::rotation(5);
  const Eigen::Matrix3d axes = principal_axes(turn * Eigen::Vector3d(1, 3, 2).asDiagonal() * turn.transpose());
  EXPECT_NEAR(axes.determinant(), 1, 1e-12);
  EXPECT_NEAR(std::abs(axes.row(0).dot(turn.col(1))), 1, 1e-12);
  EXPECT_NEAR(std::abs(axes.row(1).dot(turn.col(2))), 1, 1e-12);
  EXPECT_NEAR(std::abs(axes.row(2).dot(turn.col(0))), 1, 1e-12);
}

}  // namespace
}  // namespace shapegauge
