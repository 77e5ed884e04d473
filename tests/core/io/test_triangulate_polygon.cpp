// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/io/triangulate_polygon.h"

namespace shapegauge {

namespace {

using FlatCorners = std::vector<Eigen::Vector2d>;

const Eigen::Vector2d& corner_at(const FlatCorners& corners, std::int32_t i) {
  return corners[static_cast<std::size_t>(i)];
}

/// Twice the signed area of a triangle.
double orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

double area_of_polygon(const FlatCorners& corners) {
  double doubled = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d& next = corners[(i + 1) % corners.size()];
    doubled += corners[i].x() * next.y() - corners[i].y() * next.x();
  }
  return doubled / 2;
}

/// Whether d is inside the circle through a, b and c (counterclockwise).
bool is_in_circle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                  const Eigen::Vector2d& d) {
  Eigen::Matrix3d m;
  for (int row = 0; row < 3; ++row) {
    const Eigen::Vector2d v = (row == 0 ? a : row == 1 ? b : c) - d;
    m.row(row) << v.x(), v.y(), v.squaredNorm();
  }
  return m.determinant() > 1e-12;
}

/// Star-shaped polygon about a point near the origin, counterclockwise and simple.
FlatCorners random_polygon(std::uint64_t seed) {
  RandomNumbers random(seed);
  const std::size_t count = 4 + random.below(30);
  FlatCorners corners;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle =
        2 * std::numbers::pi * (static_cast<double>(i) + random.uniform(0.1, 0.9)) / static_cast<double>(count);
    corners.emplace_back(random.uniform(0.2, 1) * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return corners;
}

/// Spiral corridor around the origin: simple, and far from star-shaped.
FlatCorners spiral(int steps) {
  FlatCorners corners;
  const auto at = [](double angle, double radius) -> Eigen::Vector2d {
    return radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  };
  for (int i = 0; i <= steps; ++i) corners.push_back(at(0.4 * i, 1 + 0.1 * i + 0.5));
  for (int i = steps; i >= 0; --i) corners.push_back(at(0.4 * i, 1 + 0.1 * i));
  if (area_of_polygon(corners) < 0) std::ranges::reverse(corners);
  return corners;
}

/// Checks a triangulation of a simple polygon: complete, without overlaps, and Delaunay except at the polygon's sides.
void expect_constrained_delaunay(const FlatCorners& corners, const std::vector<PolygonTriangle>& triangles) {
  const auto count = static_cast<std::int32_t>(corners.size());
  ASSERT_EQ(triangles.size(), corners.size() - 2);
  double area = 0;
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> opposite;  // corner by directed edge
  for (const auto& [a, b, c] : triangles) {
    const double doubled = orientation(corner_at(corners, a), corner_at(corners, b), corner_at(corners, c));
    EXPECT_GT(doubled, 0);
    area += doubled / 2;
    for (const auto& [from, to, apex] : {std::array{a, b, c}, std::array{b, c, a}, std::array{c, a, b}}) {
      EXPECT_TRUE(opposite.emplace(std::pair(from, to), apex).second);
    }
  }
  EXPECT_NEAR(area, area_of_polygon(corners), 1e-9);
  for (std::int32_t i = 0; i < count; ++i) {
    const std::int32_t next = (i + 1) % count;
    EXPECT_TRUE(opposite.contains({i, next})) << "side " << i;
    EXPECT_FALSE(opposite.contains({next, i})) << "side " << i;
  }
  for (const auto& [edge, apex] : opposite) {
    const auto& [from, to] = edge;
    if (to == (from + 1) % count) continue;
    ASSERT_TRUE(opposite.contains({to, from}));
    EXPECT_FALSE(is_in_circle(corner_at(corners, from), corner_at(corners, to), corner_at(corners, apex),
                              corner_at(corners, opposite.at({to, from}))));
  }
}

TEST(ConstrainedDelaunay, TriangulatesSimplePolygons) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const FlatCorners corners = random_polygon(seed);
    expect_constrained_delaunay(corners, constrained_delaunay(corners));
  }
  for (const int steps : {3, 10, 40}) {
    SCOPED_TRACE(steps);
    expect_constrained_delaunay(spiral(steps), constrained_delaunay(spiral(steps)));
  }
}

double area_of(const FlatCorners& corners, const std::vector<PolygonTriangle>& triangles) {
  double area = 0;
  for (const auto& [a, b, c] : triangles) {
    area += orientation(corner_at(corners, a), corner_at(corners, b), corner_at(corners, c)) / 2;
  }
  return area;
}

TEST(ConstrainedDelaunay, ExcludesAHoleConnectedToTheOutlineByABridge) {
  const FlatCorners frame = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}};
  const std::vector<PolygonTriangle> triangles = constrained_delaunay(frame);
  for (const auto& [a, b, c] : triangles) {
    const Eigen::Vector2d centre = (corner_at(frame, a) + corner_at(frame, b) + corner_at(frame, c)) / 3;
    EXPECT_FALSE(centre.x() > 1 && centre.x() < 3 && centre.y() > 1 && centre.y() < 3) << "in the hole";
  }
  EXPECT_EQ(area_of(frame, triangles), 12);
}

TEST(ConstrainedDelaunay, CoversAPolygonWhoseSidePassesThroughOtherCorners) {
  // The first side passes through the next two corners, which go back along it.
  const FlatCorners corners = {{0, 0}, {10, 0}, {1, 0}, {4, 0}, {4, 4}, {13, 4}, {1, 6}, {3, 3}};
  EXPECT_EQ(area_of(corners, constrained_delaunay(corners)), 19.5);
}

TEST(ConstrainedDelaunay, CoversTheAreaOfAnOutlineWithRepeatedSides) {
  // An L with an area of 16, with corners anywhere on its sides, in any order.
  const FlatCorners outline = {{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 4}, {0, 4}};
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    RandomNumbers random(seed);
    FlatCorners corners;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Eigen::Vector2d way = outline[(i + 1) % outline.size()] - outline[i];
      const auto length = static_cast<std::uint64_t>(way.norm());
      corners.push_back(outline[i]);
      for (std::uint64_t visits = random.below(4); visits > 0; --visits) {
        corners.emplace_back(outline[i] + way * static_cast<double>(1 + random.below(length)) / way.norm());
      }
    }
    EXPECT_EQ(area_of(corners, constrained_delaunay(corners)), 16) << "seed " << seed;
  }
}

TEST(ConstrainedDelaunay, IsEmptyForSelfIntersectingPolygons) {
  EXPECT_TRUE(constrained_delaunay(FlatCorners{{0, 0}, {3, 3}, {3, 0}, {0, 1}}).empty());
  EXPECT_TRUE(constrained_delaunay(FlatCorners{{0, 0}, {1, 0}, {2, 0}, {3, 0}}).empty()) << "a line";
}

/// The polygon in a plane of space.
std::vector<Eigen::Vector3d> in_space(const FlatCorners& corners) {
  std::vector<Eigen::Vector3d> result;
  for (const Eigen::Vector2d& corner : corners) {
    result.emplace_back(Eigen::Vector3d(1, 2, 3) + corner.x() * Eigen::Vector3d(2, 1, 0) +
                        corner.y() * Eigen::Vector3d(0.5, 0, 3));
  }
  return result;
}

double doubled_area_of(const std::vector<Eigen::Vector3d>& corners, const PolygonTriangle& triangle,
                       const Eigen::Vector3d& normal) {
  const auto at = [&](std::int32_t i) { return corners[static_cast<std::size_t>(i)]; };
  return (at(triangle[1]) - at(triangle[0])).cross(at(triangle[2]) - at(triangle[0])).dot(normal);
}

TEST(TrianglesInPlaceOfFan, CoverThePolygonIfItsFanOverlaps) {
  const Eigen::Vector3d normal = Eigen::Vector3d(2, 1, 0).cross(Eigen::Vector3d(0.5, 0, 3)).normalized();
  int fans = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const FlatCorners flat = random_polygon(seed / 2);
    std::vector<Eigen::Vector3d> corners = in_space(flat);
    const bool is_reversed = seed % 2 == 1;
    if (is_reversed) std::reverse(corners.begin() + 1, corners.end());
    const double sign = is_reversed ? -1 : 1;
    double covered = 0;
    double polygon = 0;
    for (std::int32_t i = 2; i < std::ssize(corners); ++i) {
      const double area = doubled_area_of(corners, {0, i - 1, i}, sign * normal);
      polygon += area;
      covered += std::abs(area);
    }
    const std::vector<PolygonTriangle> triangles = triangles_in_place_of_fan(corners);
    const bool fan_covers_it = covered < polygon * (1 + 1e-9);
    ASSERT_EQ(triangles.empty(), fan_covers_it) << seed;
    fans += fan_covers_it ? 1 : 0;
    if (triangles.empty()) continue;
    EXPECT_EQ(triangles.size(), corners.size() - 2) << seed;
    double area = 0;
    for (const PolygonTriangle& triangle : triangles) {
      const double one = doubled_area_of(corners, triangle, sign * normal);
      EXPECT_GT(one, 0) << seed << ": oriented as the polygon";
      area += one;
    }
    EXPECT_NEAR(area, polygon, 1e-9) << seed;
    EXPECT_TRUE(std::ranges::is_sorted(triangles)) << seed;
    for (const PolygonTriangle& triangle : triangles) EXPECT_EQ(std::ranges::min(triangle), triangle[0]) << seed;
  }
  EXPECT_GT(fans, 10);
  EXPECT_LT(fans, 390);
}

TEST(TrianglesInPlaceOfFan, DoNotDependOnSizeAndPosition) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const std::vector<Eigen::Vector3d> corners = in_space(random_polygon(seed));
    const std::vector<PolygonTriangle> expected = triangles_in_place_of_fan(corners);
    for (const double scale : {1e-200, 3e-5, 7e6, 1e200}) {
      std::vector<Eigen::Vector3d> others = corners;
      for (Eigen::Vector3d& corner : others) corner = scale * (corner + Eigen::Vector3d(5, -3, 10));
      EXPECT_EQ(triangles_in_place_of_fan(others), expected) << seed << ", times " << scale;
    }
  }
}

TEST(TrianglesInPlaceOfFan, AreEmptyForTrianglesAndPolygonsWithoutArea) {
  EXPECT_TRUE(triangles_in_place_of_fan({}).empty());
  EXPECT_TRUE(triangles_in_place_of_fan(std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).empty());
  EXPECT_TRUE(triangles_in_place_of_fan(std::vector<Eigen::Vector3d>(7, Eigen::Vector3d(1, 2, 3))).empty());
}

}  // namespace

}  // namespace shapegauge
