// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/retrieval/descriptors/shape_dna.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

TEST(ShapeDna, OfASphereMatchesTheAnalyticEigenvalues) {
  const Eigen::VectorXf found = shape_dna(test::sphere(3, 4), {.eigenvalues = 15, .divide_by_rank = false});
  Eigen::Index k = 0;
  for (int l = 1; l <= 3; ++l) {
    // A sphere's area over 4 pi is R^2.
    for (int m = -l; m <= l; ++m, ++k) EXPECT_NEAR(found[k], l * (l + 1), 0.02 * l * (l + 1));
  }
}

TEST(ShapeDna, EigenvalueDividedByItsIndexTendsToOneOnTheSphere) {
  const Eigen::VectorXf found = shape_dna(test::sphere(1, 4), {.eigenvalues = 99, .divide_by_rank = true});
  EXPECT_NEAR(found[98], 9.0 * 10 / 99, 0.05);
}

TEST(ShapeDna, DoesNotChangeWithMotionAndScale) {
  const Shape shape = test::capsule(0.5, 2, 16, 24);
  const Shape other = test::transformed(shape, 5, test::rotation(1), {1, 2, 3});
  EXPECT_LT((shape_dna(shape) - shape_dna(other)).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(ShapeDna, OfABentSheetMatchesTheFlatSheet) {
  // A strip of triangles, flat and rolled up to half a cylinder: the edges' lengths stay.
  Shape flat;
  const int length = 40;
  flat.vertices.resize(2 * (length + 1), 3);
  flat.triangles.resize(2 * length, 3);
  for (int i = 0; i <= length; ++i) {
    flat.vertices.row(2 * i) << 0.1 * i, 0, 0;
    flat.vertices.row(2 * i + 1) << 0.1 * i, 1, 0;
    if (i == length) continue;
    flat.triangles.row(2 * i) << 2 * i, 2 * i + 2, 2 * i + 1;
    flat.triangles.row(2 * i + 1) << 2 * i + 1, 2 * i + 2, 2 * i + 3;
  }
  Shape rolled = flat;
  const double turn = 3.0 / length;
  const double radius = 0.05 / std::sin(turn / 2);
  for (int i = 0; i <= length; ++i) {
    for (const int v : {2 * i, 2 * i + 1}) {
      rolled.vertices(v, 0) = radius * std::sin(i * turn);
      rolled.vertices(v, 2) = radius * (1 - std::cos(i * turn));
    }
  }
  EXPECT_LT((shape_dna(flat) - shape_dna(rolled)).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(ShapeDna, OfTwoSpheresHasEachEigenvalueTwice) {
  const Shape one = test::sphere(1, 3);
  const Shape two = test::joined({one, test::transformed(one, 1, Eigen::Matrix3d::Identity(), {5, 0, 0})});
  const ShapeDnaOptions options{.eigenvalues = 6, .divide_by_rank = false};
  const Eigen::VectorXf of_one = shape_dna(one, options);
  // 2 of each sphere, three times, with twice the area.
  EXPECT_TRUE(shape_dna(two, options).isApprox(Eigen::VectorXf::Constant(6, 2 * of_one.head(3).mean()), 1e-3F));
}

TEST(ShapeDna, EndsWithZerosForFewVertices) {
  const Eigen::VectorXf found = shape_dna(test::box({1, 1, 1}, 1));
  EXPECT_EQ(found.size(), 20);
  EXPECT_GT(found[6], 0);
  EXPECT_EQ(found[7], 0);
}

TEST(ShapeDna, RefusesCloudsAndOptionsOutOfRange) {
  EXPECT_THROW(shape_dna(Shape{test::sphere(1, 1).vertices, {}}), InputError);
  EXPECT_THROW(shape_dna(test::sphere(1, 1), {.eigenvalues = 0}), InputError);
}

TEST(ShapeDna, DividesEachEigenvalueByItsIndexOnRequest) {
  const Shape shape = test::box({1, 2, 3}, 4);
  const Eigen::VectorXf whole = shape_dna(shape, {.eigenvalues = 5, .divide_by_rank = false});
  const Eigen::VectorXf divided = shape_dna(shape, {.eigenvalues = 5, .divide_by_rank = true});
  for (Eigen::Index k = 0; k < 5; ++k) EXPECT_FLOAT_EQ(divided[k], whole[k] / static_cast<float>(k + 1));
}

}  // namespace
}  // namespace shapegauge
