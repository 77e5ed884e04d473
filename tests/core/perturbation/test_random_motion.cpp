#include <Eigen/LU>
#include <cmath>
#include <gtest/gtest.h>

#include "shapegauge/core/error.h"
#include "shapegauge/core/perturbation/random_motion.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

Shape moved(const Shape& shape, double scale, std::uint64_t seed) {
  RandomNumbers random(seed);
  return random_motion(shape, scale, random);
}

TEST(RandomMotion, IsASimilarityThatKeepsHandedness) {
  Shape corner;
  corner.vertices.resize(4, 3);
  corner.vertices << 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Shape other = moved(corner, 10, seed);
    Eigen::Matrix3d before;
    Eigen::Matrix3d after;
    for (int k = 0; k < 3; ++k) {
      before.col(k) = (corner.vertices.row(k + 1) - corner.vertices.row(0)).transpose();
      after.col(k) = (other.vertices.row(k + 1) - other.vertices.row(0)).transpose();
    }
    const double factor = std::cbrt(after.determinant() / before.determinant());
    EXPECT_GE(factor, 0.1);
    EXPECT_LE(factor, 10);
    for (Eigen::Index i = 0; i < corner.vertices.rows(); ++i) {
      EXPECT_NEAR((other.vertices.row(i) - other.vertices.row(0)).norm(),
                  factor * (corner.vertices.row(i) - corner.vertices.row(0)).norm(), 1e-12 * factor);
    }
  }
}

TEST(RandomMotion, ScalesAreSpreadOverTheirLogarithm) {
  const Shape box = test_shapes::box({1, 1, 1}, 1);
  constexpr int n = 2000;
  double sum = 0;
  double squares = 0;
  for (std::uint64_t seed = 0; seed < n; ++seed) {
    const double logarithm = std::log(surface_area(moved(box, 5, seed)) / 6) / (2 * std::log(5.0));  // in [-1, 1]
    sum += logarithm;
    squares += logarithm * logarithm;
  }
  EXPECT_NEAR(sum / n, 0, 5 * std::sqrt(1. / 3 / n));
  EXPECT_NEAR(squares / n, 1. / 3, 5 * std::sqrt(4. / 45 / n));
}

TEST(RandomMotion, OfScaleOneKeepsSizesAndGoesNoFurtherThanTheDiagonal) {
  const Shape box = test_shapes::box({1, 2, 3}, 1);
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Shape other = moved(box, 1, seed);
    EXPECT_NEAR(surface_area(other), surface_area(box), 1e-12);
    EXPECT_LE(other.vertices.colwise().mean().norm(), bounding_box_diagonal(box) * (1 + 1e-12));
    EXPECT_NE(other.vertices, moved(box, 1, seed + 1).vertices);
    EXPECT_EQ(other.vertices, moved(box, 1, seed).vertices);
  }
}

TEST(RandomMotion, TurnsTheNormalsOfACloud) {
  Shape cloud;
  cloud.vertices = test_shapes::sphere(1, 2).vertices;
  cloud.normals = cloud.vertices;
  const Shape other = moved(cloud, 3, 1);
  const Eigen::RowVector3d centre = bounding_box(other).center().transpose();
  for (Eigen::Index i = 0; i < cloud.vertices.rows(); ++i) {
    EXPECT_NEAR(other.normals.row(i).norm(), 1, 1e-12);
    EXPECT_GT(other.normals.row(i).dot((other.vertices.row(i) - centre).normalized()), 0.99);
  }
}

TEST(RandomMotion, RefusesAShapeWithoutExtentAndAScaleBelowOne) {
  EXPECT_THROW(moved(Shape{}, 1, 1), InputError);
  for (const double scale : {0.5, -1.0, std::nan("")}) {
    EXPECT_THROW(moved(test_shapes::box({1, 1, 1}, 1), scale, 1), InputError);
  }
}

}  // namespace
}  // namespace shapegauge
