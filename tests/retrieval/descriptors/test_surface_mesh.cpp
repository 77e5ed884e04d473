// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "shapegauge/retrieval/descriptors/surface_mesh.h"
#include "shapegauge/retrieval/descriptors/surface_moments.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

TEST(SurfaceMesh, OfACloudHasFourTimesTheAreaOfTheSampledSurface) {
  const Shape ball = test::sphere(2, 5);
  const SurfaceMoments found = surface_moments(surface_mesh(test::random_points(ball, 5000, 1)));
  const double area = 16 * std::numbers::pi;
  // Weights of points are accurate to a few percent (point_weights()).
  EXPECT_NEAR(found.area, 4 * area, 0.05 * 4 * area);
  EXPECT_LT(found.centroid.norm(), 0.05);
  EXPECT_LT((found.covariance - Eigen::Matrix3d::Identity() * 4 / 3.0).norm(), 0.1);
  EXPECT_LT((found.normals - Eigen::Matrix3d::Identity() / 3).norm(), 0.02);
}

TEST(SurfaceMesh, OfACloudHasSquaresCentredOnPointsPerpendicularToNormals) {
  Shape cloud = test::random_points(test::sphere(1, 3), 50, 1);
  cloud.normals = cloud.vertices.rowwise().normalized();
  const Shape found = surface_mesh(cloud);
  ASSERT_EQ(found.triangles.rows(), 100);
  for (Eigen::Index i = 0; i < 50; ++i) {
    const auto corners = found.vertices.middleRows<4>(4 * i);
    EXPECT_LT((corners.colwise().mean() - cloud.vertices.row(i)).norm(), 1e-12) << i;
    for (Eigen::Index k = 0; k < 4; ++k) {
      EXPECT_LT(std::abs((corners.row(k) - cloud.vertices.row(i)).dot(cloud.normals.row(i))), 1e-12) << i;
    }
  }
}

TEST(SurfaceMesh, OfAMeshOmitsDuplicateTriangles) {
  const Shape box = test::box({1, 2, 3}, 1);
  EXPECT_EQ(surface_mesh(test::joined({box, box})).triangles.rows(), box.triangles.rows());
}

}  // namespace
}  // namespace shapegauge
