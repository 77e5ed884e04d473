// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gtest/gtest.h>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/datasets/generator/class_skeletons.h"
#include "shapegauge/datasets/generator/implicit_surface.h"

namespace shapegauge {

namespace {

Eigen::Vector3d random_point(RandomNumbers& random, double extent) {
  const double x = random.uniform(-extent, extent);
  const double y = random.uniform(-extent, extent);
  return {x, y, random.uniform(-extent, extent)};
}

TEST(ImplicitSurface, OfOneStraightLimbIsTheDistanceToACapsule) {
  const Skeleton s{"", {{.kind = "rod", .nodes = {{{-1, 0, 0}, 0.3}, {{0, 0, 0}, 0.3}, {{1, 0, 0}, 0.3}}}}};
  const ImplicitSurface surface(s);
  RandomNumbers random(1);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d p = random_point(random, 2);
    const double distance = (p - Eigen::Vector3d(std::clamp(p.x(), -1.0, 1.0), 0, 0)).norm() - 0.3;
    EXPECT_NEAR(surface(p), distance, 1e-12);
  }
}

TEST(ImplicitSurface, OfATaperedLimbIsTheDistanceToTheUnionOfItsBalls) {
  // Two nodes only: the smoothing spline moves the balls along the line, but the radius stays between its ends.
  const Skeleton s{"", {{.kind = "cone", .nodes = {{{-1, 0, 0}, 0.5}, {{1, 0, 0}, 0.1}}}}};
  const ImplicitSurface surface(s);
  RandomNumbers random(2);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d p = random_point(random, 2);
    double least = 1e9;
    constexpr int balls = 3000;
    for (int k = 0; k <= balls; ++k) {
      // Position and radius follow the same spline, so that the radius is linear in the position.
      const double x = -1 + 2.0 * k / balls;
      least = std::min(least, (p - Eigen::Vector3d(x, 0, 0)).norm() - (0.3 - 0.2 * x));
    }
    EXPECT_NEAR(surface(p), least, 1e-3);
  }
}

TEST(ImplicitSurface, OfAFlattenedLimbIsThinAlongItsAxis) {
  const Skeleton s{
      "",
      {{.kind = "plate", .nodes = {{{-1, 0, 0}, 0.4}, {{1, 0, 0}, 0.4}}, .flat_axis = {0, 0, 1}, .flatness = 0.25}}};
  const ImplicitSurface surface(s);
  EXPECT_NEAR(surface({0, 0, 0.1}), 0, 1e-12);
  EXPECT_NEAR(surface({0, 0.4, 0}), 0, 1e-12);
  EXPECT_LT(surface({0, 0.3, 0}), 0);
  EXPECT_GT(surface({0, 0, 0.15}), 0);
}

TEST(SmoothMinimum, OfEqualValuesIsLowerByAQuarterOfTheWidth) {
  EXPECT_DOUBLE_EQ(smooth_minimum(1, 1, 0.4), 0.9);
  EXPECT_DOUBLE_EQ(smooth_minimum(1, 1.2, 0.4), 0.975);
  EXPECT_DOUBLE_EQ(smooth_minimum(1.2, 1, 0.4), 0.975);
  EXPECT_EQ(smooth_minimum(1, 1.4, 0.4), 1);
  EXPECT_EQ(smooth_minimum(3, 1, 0.4), 1);
}

TEST(ImplicitSurface, BlendingEnlargesTheUnionOfLimbsOnlyNearJoints) {
  const Skeleton s = class_skeleton(0);
  const ImplicitSurface surface(s);
  RandomNumbers random(3);
  for (int i = 0; i < 3000; ++i) {
    const Eigen::Vector3d p = random_point(random, 2.5);
    double least = 1e9;
    double second = 1e9;
    for (int limb = 0; limb < surface.limb_count(); ++limb) {
      const double distance = surface.nearest_on_limb(limb, p).distance;
      second = std::min(second, std::max(least, distance));
      least = std::min(least, distance);
    }
    EXPECT_LE(surface(p), least);
    EXPECT_NEAR(surface.nearest_limb(p).distance, least, 1e-12);
    double widest = 0;
    for (const Limb& limb : s.limbs) widest = std::max(widest, limb.blend * limb.nodes.front().radius);
    if (second - least > widest) {
      EXPECT_NEAR(surface(p), least, 1e-12);
    }
  }
}

TEST(ImplicitSurface, OfEveryClassLiesInItsBoundingBall) {
  RandomNumbers random(4);
  for (std::size_t c = 0; c < articulated_class_count(); ++c) {
    const ImplicitSurface surface(class_skeleton(c));
    EXPECT_LT(surface(surface.centre()), 0);
    for (const Eigen::Vector3d& point : surface.inner_points()) EXPECT_LT(surface(point), 0);
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector3d direction = random_point(random, 1).normalized();
      EXPECT_GT(surface(surface.centre() + surface.radius() * direction), 0);
    }
  }
}

}  // namespace

}  // namespace shapegauge
