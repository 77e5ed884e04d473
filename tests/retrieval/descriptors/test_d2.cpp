// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/retrieval/descriptors/d2.h"
#include "shapegauge/retrieval/l1_distance.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

double distance_of_d2(const Eigen::VectorXf& a, const Eigen::VectorXf& b) {
  return l1_distance({a.data(), static_cast<std::size_t>(a.size())}, {b.data(), static_cast<std::size_t>(b.size())});
}

TEST(D2Descriptor, OfASphereMatchesTheTheoreticalDistanceDistribution) {
  const Eigen::VectorXf found = d2(test::sphere(2, 4), {.points = 2000, .bins = 30, .longest = 1.5});
  // The fraction of distances up to d is d^2 / (4 R^2), the mean 4 R / 3; a bin is 1/20 of the mean.
  for (Eigen::Index bin = 0; bin < found.size(); ++bin) {
    const double low = static_cast<double>(bin) / 20 * 4 / 3;
    const double high = static_cast<double>(bin + 1) / 20 * 4 / 3;
    EXPECT_NEAR(found[bin], (high * high - low * low) / 4, 0.004) << bin;
  }
}

TEST(D2Descriptor, HardlyChangesWithMotionScaleAndMeshing) {
  const Shape shape = test::box({1, 2, 3}, 4);
  const Eigen::VectorXf expected = d2(shape);
  EXPECT_LT(distance_of_d2(d2(test::transformed(shape, 5, test::rotation(1), {1, 2, 3})), expected), 1e-3);
  // Other samples of the same surface: the difference is sampling noise, far less than for another shape.
  const double other_mesh = distance_of_d2(d2(test::soup(test::box({1, 2, 3}, 9))), expected);
  const double other_shape = distance_of_d2(d2(test::box({1, 1, 3}, 4)), expected);
  EXPECT_LT(other_mesh, 0.05);
  EXPECT_GT(other_shape, 3 * other_mesh);
}

TEST(D2Descriptor, OfAPointCloudIsCloseToThatOfItsMesh) {
  const Shape ball = test::sphere(1, 4);
  EXPECT_LT(distance_of_d2(d2(Shape{ball.vertices, {}}), d2(ball)), 0.05);
}

/// Pairs are weighted by the areas of their points.
TEST(D2Descriptor, DoesNotDependOnTheDensityOfACloud) {
  // Two plates, 4 apart: three quarters of the points are on the first, each with a third of the weight.
  const auto plate = [](Eigen::Index points, double z, std::uint64_t seed) {
    const Shape square{Points{{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}}, Triangles{{0, 1, 2}, {0, 2, 3}}};
    return test::random_points(square, points, seed).vertices;
  };
  Points uneven(1200, 3);
  uneven << plate(900, 0, 1), plate(300, 4, 2);
  Points even(600, 3);
  even << plate(300, 0, 3), plate(300, 4, 4);
  const Eigen::VectorXf expected = d2(Shape{even, {}}, {.points = 1200, .bins = 12});
  // By their number, 10/16 of the pairs would be on one plate, not a half: a distance of 1/4 at least.
  EXPECT_LT(distance_of_d2(d2(Shape{uneven, {}}, {.points = 1200, .bins = 12}), expected), 0.15);
}

TEST(D2Descriptor, RejectsOptionsOutOfRangeAndCoincidentPoints) {
  const Shape ball = test::sphere(1, 1);
  EXPECT_THROW(d2(ball, {.points = 1}), InputError);
  EXPECT_THROW(d2(ball, {.bins = 0}), InputError);
  EXPECT_THROW(d2(ball, {.longest = 0}), InputError);
  EXPECT_THROW(d2(Shape{}), InputError);
  EXPECT_THROW(d2(Shape{Points::Zero(5, 3), {}}), InputError);
}

}  // namespace
}  // namespace shapegauge
