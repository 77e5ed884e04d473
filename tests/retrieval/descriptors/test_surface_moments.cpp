#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <numbers>

#include "shapegauge/retrieval/descriptors/splats.h"
#include "shapegauge/retrieval/descriptors/surface_moments.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

TEST(SurfaceMoments, OfABoxAreThoseOfItsSides) {
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

TEST(SurfaceMoments, OfAMeshWithoutAreaAreZero) {
  EXPECT_EQ(surface_moments(Shape{}).area, 0);
  EXPECT_EQ(surface_moments(Shape{Points::Zero(3, 3), Triangles{{0, 1, 2}}}).covariance.norm(), 0);
}

TEST(PrincipalAxes, AreTheRowsOfARotationByFallingEigenvalue) {
  const Eigen::Matrix3d turn = test::rotation(5);
  const Eigen::Matrix3d axes = principal_axes(turn * Eigen::Vector3d(1, 3, 2).asDiagonal() * turn.transpose());
  EXPECT_NEAR(axes.determinant(), 1, 1e-12);
  EXPECT_NEAR(std::abs(axes.row(0).dot(turn.col(1))), 1, 1e-12);
  EXPECT_NEAR(std::abs(axes.row(1).dot(turn.col(2))), 1, 1e-12);
  EXPECT_NEAR(std::abs(axes.row(2).dot(turn.col(0))), 1, 1e-12);
}

TEST(Splats, HaveFourTimesTheAreaAndTheMomentsOfTheSurface) {
  const Shape ball = test::sphere(2, 5);
  const SurfaceMoments found = surface_moments(splatted(test::random_points(ball, 5000, 1)));
  const double area = 16 * std::numbers::pi;
  // Weights of points are accurate to a few percent (point_weights()).
  EXPECT_NEAR(found.area, 4 * area, 0.05 * 4 * area);
  EXPECT_LT(found.centroid.norm(), 0.05);
  EXPECT_LT((found.covariance - Eigen::Matrix3d::Identity() * 4 / 3.0).norm(), 0.1);
  EXPECT_LT((found.normals - Eigen::Matrix3d::Identity() / 3).norm(), 0.02);
}

TEST(Splats, LieAcrossTheNormalsAboutThePoints) {
  Shape cloud = test::random_points(test::sphere(1, 3), 50, 1);
  cloud.normals = cloud.vertices.rowwise().normalized();
  const Shape found = splatted(cloud);
  ASSERT_EQ(found.triangles.rows(), 100);
  for (Eigen::Index i = 0; i < 50; ++i) {
    const auto corners = found.vertices.middleRows<4>(4 * i);
    EXPECT_LT((corners.colwise().mean() - cloud.vertices.row(i)).norm(), 1e-12) << i;
    for (Eigen::Index k = 0; k < 4; ++k) {
      EXPECT_LT(std::abs((corners.row(k) - cloud.vertices.row(i)).dot(cloud.normals.row(i))), 1e-12) << i;
    }
  }
}

TEST(Splats, AMeshLosesItsDoubles) {
  const Shape box = test::box({1, 2, 3}, 1);
  EXPECT_EQ(splatted(test::joined({box, box})).triangles.rows(), box.triangles.rows());
}

}  // namespace
}  // namespace shapegauge
