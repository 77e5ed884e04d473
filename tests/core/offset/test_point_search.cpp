// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <hwy/targets.h>
#include <limits>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/offset/point_search.h"
#include "shapegauge/core/shape/shape.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

struct Surface {
  Surface(const Shape& shape, double r) : grid(bounding_box(shape), r, r / 3), surface(grid, shape, 0.75, false) {}

  [[nodiscard]] Eigen::Vector3d point(std::size_t i) const {
    return Eigen::Vector3f(surface.points.x[i], surface.points.y[i], surface.points.z[i]).cast<double>();
  }
  [[nodiscard]] Eigen::Vector3d anywhere(RandomNumbers& random) const {
    return {random.uniform(0, block_edge * grid.blocks.x()), random.uniform(0, block_edge * grid.blocks.y()),
            random.uniform(0, block_edge * grid.blocks.z())};
  }

  BlockGrid grid;
  GridSurface surface;
};

/// Points so sparse that a group has those of several blocks.
Shape sparse_cloud() {
  RandomNumbers random(3);
  Shape cloud{.vertices = Points(300, 3), .triangles = {}};
  for (double& coordinate : cloud.vertices.reshaped()) coordinate = random.uniform(-1, 1);
  return cloud;
}

/// Surfaces on which most triangles have one point, and several, and a cloud.
std::vector<Surface> surfaces() {
  return {{test::torus(1, 0.4, 120, 60), 0.2}, {test::torus(1, 0.4, 15, 10), 0.2}, {sparse_cloud(), 0.2}};
}

TEST(PointSearch, FindsAllPointsWithinADistance) {
  RandomNumbers random(1);
  for (const Surface& of : surfaces()) {
    for (int round = 0; round < 300; ++round) {
      const Eigen::Vector3d x = of.anywhere(random);
      const double distance = random.uniform(0.1, 9);
      std::vector<std::uint32_t> found;
      find_points_within(of.grid, of.surface.points, x, distance, found);
      std::vector<std::uint32_t> expected;
      std::vector<std::uint32_t> nearly;
      for (std::size_t i = 0; i < of.surface.points.size(); ++i) {
        const double to_point = (of.point(i) - x).norm();
        if (to_point < distance - 1e-4) expected.push_back(static_cast<std::uint32_t>(i));
        if (to_point < distance + 1e-4) nearly.push_back(static_cast<std::uint32_t>(i));
      }
      ASSERT_TRUE(std::is_sorted(found.begin(), found.end()));
      ASSERT_TRUE(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
      ASSERT_TRUE(std::includes(nearly.begin(), nearly.end(), found.begin(), found.end()));
    }
  }
}

TEST(ClosestTriangles, MatchExhaustiveSearchNearARegion) {
  RandomNumbers random(2);
  for (const Surface& of : surfaces()) {
    ClosestTriangles closest(of.grid, of.surface);
    const double edge = closest.region_edge();
    const double shift = closest.region_shift();
    const std::size_t count = of.surface.points.size();
    for (int round = 0; round < 1000; ++round) {
      const Eigen::Vector3d hint = of.point(random.below(count));
      const Eigen::Vector3d x =
          hint + Eigen::Vector3d(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3));
      const Eigen::Vector3d centre = edge * (((hint.array() + shift) / edge).floor() + 0.5) - shift;
      double nearest = std::numeric_limits<double>::infinity();
      std::int32_t expected = -1;
      for (std::size_t i = 0; i < count; ++i) {
        if ((of.point(i) - centre).cwiseAbs().maxCoeff() > edge / 2 + ClosestTriangles::reach) continue;
        if ((of.point(i) - x).norm() >= nearest) continue;
        nearest = (of.point(i) - x).norm();
        expected = of.surface.points.triangle[i];
      }
      const std::int32_t found = closest.closest_near(hint, x);
      ASSERT_GE(found, 0);
      const auto distance = [&](std::int32_t triangle) {
        return std::sqrt(of.surface.triangles.squared_distance(x, triangle));
      };
      EXPECT_LE(distance(found), distance(expected) + 1e-4);
      // The answer of a new search, whose cache is empty, is the same.
      if (round % 10 == 0) {
        EXPECT_EQ(ClosestTriangles(of.grid, of.surface).closest_near(hint, x), found);
      }
    }
  }
}

TEST(ClosestTriangles, MatchExhaustiveSearchWithinADistance) {
  RandomNumbers random(3);
  for (const Surface& of : surfaces()) {
    ClosestTriangles closest(of.grid, of.surface);
    for (int round = 0; round < 300; ++round) {
      const Eigen::Vector3d x = of.anywhere(random);
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < of.surface.points.size(); ++i) nearest = std::min(nearest, (of.point(i) - x).norm());
      const std::int32_t found = closest.closest_within(4, x);
      if (found < 0) {
        EXPECT_GT(nearest, 4 - 1e-4);
      } else if (nearest < 4) {
        EXPECT_LE(std::sqrt(of.surface.triangles.squared_distance(x, found)), nearest + 1e-4);
      }
    }
  }
}

TEST(ClosestTriangles, TiesGoToTheLowestIndexForEveryVectorWidth) {
  for (const Shape& shape : {test::torus(1, 0.4, 15, 10), test::sphere(1, 4)}) {
    const Surface of(test::joined({shape, shape}), 0.2);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
      hwy::SetSupportedTargetsForTest(target);
      RandomNumbers random(5);
      ClosestTriangles closest(of.grid, of.surface);
      for (int round = 0; round < 200; ++round) {
        const Eigen::Vector3d point = of.point(random.below(of.surface.points.size()));
        EXPECT_LT(closest.closest_near(point, point), shape.triangles.rows());
        EXPECT_LT(closest.closest_within(3, point), shape.triangles.rows());
      }
    }
    hwy::SetSupportedTargetsForTest(0);
  }
}

TEST(ClosestTriangles, AreNotFoundForNonFinitePoints) {
  const Surface of(test::sphere(1, 4), 0.2);
  ClosestTriangles closest(of.grid, of.surface);
  const Eigen::Vector3d nowhere = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(closest.closest_near(of.point(0), nowhere), -1);
}

TEST(ClosestTriangles, AreNotFoundFarFromTheSurface) {
  const Surface of(test::sphere(1, 4), 0.1);
  ClosestTriangles closest(of.grid, of.surface);
  const Eigen::Vector3d middle = of.grid.to_cells({0, 0, 0});
  EXPECT_EQ(closest.closest_near(middle, middle), -1);
  EXPECT_EQ(closest.closest_within(1, middle), -1);
}

}  // namespace
}  // namespace shapegauge
