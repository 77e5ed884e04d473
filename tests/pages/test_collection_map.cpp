// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "shapegauge/pages/collection_map.h"

namespace shapegauge {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Distances of points of the plane.
Eigen::MatrixXd distances_between(const Eigen::MatrixX2d& points) {
  Eigen::MatrixXd distances(points.rows(), points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    for (Eigen::Index j = 0; j < points.rows(); ++j) distances(i, j) = (points.row(i) - points.row(j)).norm();
  }
  return distances;
}

TEST(PlaneEmbedding, RestoresPointsInAPlaneUpToRigidMotion) {
  const Eigen::MatrixX2d points{{0, 0}, {5, 1}, {2, 3}, {-1, 4}, {7, -2}, {3, 3}};
  const Eigen::MatrixXd distances = distances_between(points);
  const Eigen::MatrixX2d positions = plane_embedding(distances);
  EXPECT_TRUE(distances_between(positions).isApprox(distances, 1e-9));
  EXPECT_LT(positions.colwise().mean().norm(), 1e-9);
  EXPECT_GT(positions.col(0).squaredNorm(), positions.col(1).squaredNorm());
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_DOUBLE_EQ(positions.col(axis).maxCoeff(), positions.col(axis).cwiseAbs().maxCoeff());
  }
}

TEST(PlaneEmbedding, GivesNoPositionToModelsWithoutFiniteDistances) {
  const Eigen::MatrixX2d points{{0, 0}, {4, 0}, {0, 3}};
  Eigen::MatrixXd distances = Eigen::MatrixXd::Constant(4, 4, infinity);
  distances.topLeftCorner(3, 3) = distances_between(points);
  distances(3, 3) = 0;
  const Eigen::MatrixX2d positions = plane_embedding(distances);
  EXPECT_TRUE(distances_between(positions.topRows(3)).isApprox(distances_between(points), 1e-9));
  EXPECT_TRUE(std::isnan(positions(3, 0)) && std::isnan(positions(3, 1)));
}

}  // namespace
}  // namespace shapegauge
