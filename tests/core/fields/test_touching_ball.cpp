// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/fields/touching_ball.h"

namespace shapegauge {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double radius_of(const Triangle& triangle, const Eigen::Vector3d& normal) {
  const OppositePoints all{.direction = normal, .cone_cosine = 0, .min_cosine = -1, .rounding = 1e-9};
  return touching_radius(triangle, oriented_normal(triangle), all, infinity);
}

/// Brute force: candidate points on a regular grid over the triangle.
double sampled_radius(const Triangle& triangle, const Eigen::Vector3d& normal) {
  constexpr int steps = 120;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps - i; ++j) {
      const double b = static_cast<double>(i) / steps;
      const double c = static_cast<double>(j) / steps;
      const Eigen::Vector3d q = (1 - b - c) * triangle.a + b * triangle.b + c * triangle.c;
      const double height = q.dot(normal);
      if (height > 0) least = std::min(least, q.squaredNorm() / (2 * height));
    }
  }
  return least;
}

TEST(TouchingBall, RadiusIsTheMinimumOverPointsOfTheTriangle) {
  RandomNumbers random(7);
  const auto vector = [&] {
    return Eigen::Vector3d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  };
  int stopped = 0;
  for (int i = 0; i < 100; ++i) {
    const Triangle triangle{vector(), vector(), vector()};
    const Eigen::Vector3d normal = vector().normalized();
    const double sampled = sampled_radius(triangle, normal);
    const double radius = radius_of(triangle, normal);
    if (std::isinf(sampled)) continue;  // the grid may miss a corner above the plane
    ++stopped;
    ASSERT_LT(radius, infinity);
    EXPECT_LE(radius, sampled * (1 + 1e-9));
    if (sampled < 3) {
      EXPECT_NEAR(radius, sampled, 0.1 * sampled) << i;
    }
  }
  EXPECT_GT(stopped, 30);
}

TEST(TouchingBall, TouchesThePlaneSideOrCornerOfATriangle) {
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const Triangle lid{{-5, -5, 2}, {5, -5, 2}, {0, 5, 2}};
  EXPECT_DOUBLE_EQ(radius_of(lid, up), 1);
  EXPECT_EQ(radius_of(lid, -up), infinity);
  const Triangle wall{{1, -5, -5}, {1, 5, -5}, {1, 0, 9}};  // touched at the height of its distance
  EXPECT_DOUBLE_EQ(radius_of(wall, up), 1);
  const Triangle high_wall{{1, -5, 3}, {1, 5, 3}, {1, 0, 9}};  // touched at its lower side
  EXPECT_DOUBLE_EQ(radius_of(high_wall, up), 10.0 / 6);
  const Triangle tip{{0, 0, 3}, {1, 0, 9}, {0, 1, 9}};
  EXPECT_DOUBLE_EQ(radius_of(tip, up), 1.5);
  const Triangle degenerate{{2, -1, 2}, {2, 1, 2}, {2, 0, 2}};
  EXPECT_EQ(radius_of(degenerate, up), infinity);
  EXPECT_EQ(radius_of({{0, 0, 0}, {1, 0, 1}, {0, 1, 1}}, up), infinity);
}

TEST(TouchingBall, RadiusIsLimitedByOppositePointsOnly) {
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const OppositePoints opposite{
      .direction = up, .cone_cosine = std::cos(std::numbers::pi / 4), .min_cosine = 0.1, .rounding = 1e-9};
  const auto radius = [&](const Triangle& triangle) {
    return touching_radius(triangle, oriented_normal(triangle), opposite, infinity);
  };
  const Triangle wall{{1, -5, -5}, {1, 5, -5}, {1, 0, 9}};
  EXPECT_EQ(radius(wall), infinity);  // its normal is horizontal
  // A lid is stopped at the border of the cone, or where it begins within the cone.
  EXPECT_DOUBLE_EQ(radius({{1, -9, 2}, {1, 9, 2}, {9, 0, 2}}), 5.0 / 4);
  EXPECT_EQ(radius({{2.1, -9, 2}, {2.1, 9, 2}, {9, 0, 2}}), infinity);
  // An edge parallel to the border of the cone enters it at (1.5, 2, 2.5).
  EXPECT_NEAR(radius({{-1, 2, 0}, {3, 2, 4}, {-1, 30, 0}}), 2.5, 1e-12);
}

}  // namespace
}  // namespace shapegauge
