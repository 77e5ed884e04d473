// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/LU>
#include <cmath>
#include <gmock/gmock.h>
#include <numbers>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/proxy/local_delaunay.h"

namespace shapegauge {
namespace {

using Triangle = std::array<std::int32_t, 2>;

/// Whether the circle through the origin, a and b holds c (determinant test; a, b counterclockwise).
bool circle_holds(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  Eigen::Matrix3d m;
  m << a.x(), a.y(), a.squaredNorm(), b.x(), b.y(), b.squaredNorm(), c.x(), c.y(), c.squaredNorm();
  return m.determinant() < 0;
}

/// All counterclockwise triangles at the origin whose circles hold no other point.
std::vector<Triangle> empty_circles(const std::vector<Eigen::Vector2d>& points) {
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < points.size(); ++j) {
      const Eigen::Vector2d& a = points[i];
      const Eigen::Vector2d& b = points[j];
      if (!(a.x() * b.y() - a.y() * b.x() > 0)) continue;
      bool empty = true;
      for (std::size_t k = 0; k < points.size(); ++k) {
        if (k != i && k != j && circle_holds(a, b, points[k])) empty = false;
      }
      if (empty) triangles.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)});
    }
  }
  return triangles;
}

TEST(DelaunayStar, HasExactlyTheTrianglesWithEmptyCircumcircles) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    RandomNumbers random(seed);
    std::vector<Eigen::Vector2d> points(3 + random.below(20));
    const double lowest = seed % 3 == 0 ? 0.1 : -1;  // a third of them at a border
    for (Eigen::Vector2d& p : points) p = {random.uniform(-1, 1), random.uniform(lowest, 1)};
    EXPECT_THAT(delaunay_star(points), testing::UnorderedElementsAreArray(empty_circles(points))) << seed;
  }
}

TEST(DelaunayStar, OfAHexagonHasSixTriangles) {
  std::vector<Eigen::Vector2d> points;
  for (int k = 0; k < 6; ++k) {
    points.emplace_back(std::cos(k * std::numbers::pi / 3), std::sin(k * std::numbers::pi / 3));
    points.emplace_back(2 * points.back());  // behind, and no neighbours
  }
  EXPECT_EQ(delaunay_star(points).size(), 6U);
}

TEST(DelaunayStar, IsEmptyForTooFewOrCollinearPoints) {
  EXPECT_TRUE(delaunay_star({}).empty());
  EXPECT_TRUE(delaunay_star(std::vector<Eigen::Vector2d>{{1, 0}}).empty());
  EXPECT_TRUE(delaunay_star(std::vector<Eigen::Vector2d>{{1, 0}, {2, 0}, {-1, 0}}).empty());
  EXPECT_TRUE(delaunay_star(std::vector<Eigen::Vector2d>{{0, 0}, {0, 0}, {1, 1}}).empty());
}

}  // namespace
}  // namespace shapegauge
