// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/datasets/generator/solid.h"

namespace shapegauge {

namespace {

using Eigen::Vector3d;

Vector3d random_position(RandomNumbers& random, double extent) {
  const double x = random.uniform(-extent, extent);
  const double y = random.uniform(-extent, extent);
  return {x, y, random.uniform(-extent, extent)};
}

template <typename Distance>
void expect_distance(const Solid& solid, Distance distance) {
  RandomNumbers random(1);
  for (int i = 0; i < 500; ++i) {
    const Vector3d point = random_position(random, 2);
    EXPECT_NEAR(solid.distance(point), distance(point), 1e-12) << point.transpose();
    if (solid.distance(point) < 0) {
      EXPECT_TRUE(solid.box.contains(point)) << point.transpose();
    }
  }
}

TEST(Solid, RoundedBoxDistanceIsTheCoreDistanceMinusTheRadius) {
  const Vector3d centre(0.2, -0.1, 0.3);
  expect_distance(rounded_box(centre, {0.6, 0.5, 0.4}, 0.4), [&](const Vector3d& point) {
    // A core of height 0: every point is outside.
    const Vector3d local = point - centre;
    const Vector3d nearest(std::clamp(local.x(), -0.2, 0.2), std::clamp(local.y(), -0.1, 0.1), 0);
    return (local - nearest).norm() - 0.4;
  });
}

TEST(Solid, RevolvedHalfCircleHasTheDistancesOfABall) {
  constexpr int pieces = 2000;
  Outline outline;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = std::numbers::pi * (i / static_cast<double>(pieces) - 0.5);
    outline.emplace_back(std::cos(angle), std::sin(angle));
  }
  const Solid ball = revolved(outline, 0);
  const Solid shell = revolved_wall(outline, 0.2);
  RandomNumbers random(2);
  // Chords leave the circle by less than the square of their half length, over twice the radius.
  constexpr double tolerance = 1e-6;
  for (int i = 0; i < 100; ++i) {
    const Vector3d point = random_position(random, 1.2);
    EXPECT_NEAR(ball.distance(point), point.norm() - 1, tolerance);
    EXPECT_NEAR(shell.distance(point), std::abs(point.norm() - 1) - 0.1, tolerance);
  }
}

TEST(Solid, RoundedCylinderHasTheExactSignedDistance) {
  const Vector3d from(-0.5, 0.2, 0.1);
  const Vector3d to(0.7, -0.3, 0.4);
  const Vector3d axis = (to - from).normalized();
  const double length = (to - from).norm();
  expect_distance(rounded_cylinder(from, to, 0.4, 0.1), [&](const Vector3d& point) {
    const double along = std::abs((point - from).dot(axis) - length / 2) - (length / 2 - 0.1);
    const double across = (point - from - (point - from).dot(axis) * axis).norm() - 0.3;
    return std::hypot(std::max(along, 0.0), std::max(across, 0.0)) + std::min(std::max(along, across), 0.0) - 0.1;
  });
}

TEST(Solid, IntersectionIsInsideBothSolidsAndDifferenceOnlyInsideTheFirst) {
  const Solid one = rounded_box(Vector3d::Zero(), {0.8, 0.7, 0.6}, 0.1);
  const Solid other = rounded_box({0.5, 0, 0}, {0.6, 0.3, 1}, 0.1);
  RandomNumbers random(3);
  for (int i = 0; i < 500; ++i) {
    const Vector3d point = random_position(random, 1.2);
    const bool in_one = one.distance(point) < 0;
    const bool in_other = other.distance(point) < 0;
    EXPECT_EQ(intersection(one, other).distance(point) < 0, in_one && in_other);
    EXPECT_EQ(difference(one, other).distance(point) < 0, in_one && !in_other);
    EXPECT_EQ(intersection(one, slab(-0.2, 0.3)).distance(point) < 0, in_one && point.z() > -0.2 && point.z() < 0.3);
  }
}

TEST(Solid, RotatedSolidHasTheOriginalDistancesAtRotatedPoints) {
  const Solid box = rounded_box({0.5, 0, 0}, {0.5, 0.2, 0.1}, 0.05);
  const Solid turned = rotated_about_z(box, 90);
  RandomNumbers random(4);
  for (int i = 0; i < 200; ++i) {
    const Vector3d point = random_position(random, 1.5);
    EXPECT_NEAR(turned.distance({-point.y(), point.x(), point.z()}), box.distance(point), 1e-12);
  }
  EXPECT_NEAR(turned.box.max().y(), 1, 1e-12);
}

TEST(SolidObject, LabelIsTheNearestPartOrTheFirstIfEquallyNear) {
  SolidObject object;
  object.parts.push_back({3, rounded_box({-0.5, 0, 0}, {0.5, 0.2, 0.2}, 0.01)});
  object.parts.push_back({1, rounded_box({0.5, 0, 0}, {0.5, 0.2, 0.2}, 0.01)});
  EXPECT_EQ(object.label_at({-0.7, 0.2, 0}), 3);
  EXPECT_EQ(object.label_at({0.7, 0.2, 0}), 1);
  EXPECT_EQ(object.label_at({0, 0.2, 0}), 3);
  EXPECT_LT(object.distance({0, 0, 0}), 0);
}

}  // namespace

}  // namespace shapegauge
