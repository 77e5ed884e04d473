#include <cmath>
#include <gtest/gtest.h>

#include "shapegauge/core/shape/point_normals.h"
#include "tests/core/random_points.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

Points random_points_of_sphere() { return test_shapes::random_points(test_shapes::sphere(1, 5), 5000, 1).vertices; }

TEST(PointNormals, OfAPlaneAreItsNormalAtAnyScale) {
  const Eigen::Matrix3d turn = test_shapes::rotation(4);
  for (const double scale : {1e-30, 1.0, 1e30}) {
    Points points = Points::Random(500, 3);
    points.col(2).setZero();
    points = (scale * points * turn.transpose()).eval();
    const Points normals = unsigned_point_normals(points);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      EXPECT_NEAR(std::abs(normals.row(i).dot(turn.col(2))), 1, 1e-6) << i;
      EXPECT_NEAR(normals.row(i).norm(), 1, 1e-12);
    }
  }
}

TEST(PointNormals, OfASphereAreRadial) {
  const Points points = random_points_of_sphere();
  const Points normals = unsigned_point_normals(points);
  double sum = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double cosine = std::abs(normals.row(i).dot(points.row(i).normalized()));
    EXPECT_GT(cosine, std::cos(0.5)) << i;
    sum += cosine;
  }
  EXPECT_GT(sum / static_cast<double>(points.rows()), std::cos(0.05));  // 3 degrees; the neighbours are within 0.1
}

TEST(PointNormals, OfPointsAtOnePlaceAreZero) {
  EXPECT_TRUE(unsigned_point_normals(Points::Constant(20, 3, 5)).isZero(0));
  EXPECT_TRUE(unsigned_point_normals(Points::Zero(1, 3)).isZero(0));
  // Thirteen at one place amid others: none of the twelve nearest is elsewhere.
  Points points = random_points_of_sphere();
  points.topRows(13).rowwise() = points.row(0).eval();
  const Points normals = unsigned_point_normals(points);
  EXPECT_TRUE(normals.topRows(13).isZero(0));
  for (Eigen::Index i = 13; i < points.rows(); ++i) EXPECT_NEAR(normals.row(i).norm(), 1, 1e-12);
}

}  // namespace
}  // namespace shapegauge
