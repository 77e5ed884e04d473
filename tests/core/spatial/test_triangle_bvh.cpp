// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/spatial/triangle_bvh.h"
#include "tests/core/spatial/random_triangle.h"
#include "tests/core/spatial/soups.h"
#include "tests/support/test_shapes.h"

/// Compares the tree with brute force on difficult soups.
namespace shapegauge {

namespace {

double distance_to(const Shape& shape, Eigen::Index f, const Eigen::Vector3d& x) {
  return (closest_point(triangle_of(shape, f), x) - x).norm();
}

double distance_to_all(const Shape& shape, const Eigen::Vector3d& x) {
  double distance = std::numeric_limits<double>::infinity();
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) distance = std::min(distance, distance_to(shape, f, x));
  return distance;
}

/// A point on the soup, near it, or at one of its vertices.
Eigen::Vector3d any_query(const Shape& shape) {
  if (*rc::gen::inRange(0, 4) == 0) {
    return shape.vertices.row(*rc::gen::inRange<int>(0, static_cast<int>(shape.vertices.rows())));
  }
  return 2 * random_point();
}

/// Single precision decides which triangle is closest (triangle_bvh.h); the soups are of size 1.
double tolerance_at(double distance) { return 1e-6 * (1 + distance); }

RC_GTEST_PROP(TriangleBVH, FindsTheClosestTriangleOfASoup, ()) {
  const Shape shape = any_soup(300);
  const TriangleBVH tree(shape);
  const Eigen::Vector3d x = any_query(shape);
  const double expected = distance_to_all(shape, x);
  const auto found = tree.closest(x);
  RC_ASSERT(found.has_value());
  RC_ASSERT(found->distance >= expected);
  RC_ASSERT(found->distance <= expected + tolerance_at(expected));
  RC_ASSERT(found->distance == distance_to(shape, found->triangle, x));
  RC_ASSERT(std::abs((found->point - x).norm() - found->distance) <= 1e-12);
  const int hint = *rc::gen::inRange(0, static_cast<int>(shape.triangles.rows()));
  const auto hinted = tree.closest(x, INFINITY, hint);
  RC_ASSERT(hinted.has_value());
  RC_ASSERT(std::abs(hinted->distance - expected) <= tolerance_at(expected));
}

RC_GTEST_PROP(TriangleBVH, FindsNoTriangleBeyondTheDistanceLimit, ()) {
  const Shape shape = any_soup(300);
  const TriangleBVH tree(shape);
  const Eigen::Vector3d x = any_query(shape);
  const double expected = distance_to_all(shape, x);
  const int hint = *rc::gen::inRange(-1, static_cast<int>(shape.triangles.rows()));
  RC_ASSERT(!tree.closest(x, expected * 0.999, hint).has_value());
  RC_ASSERT(tree.closest(x, expected + tolerance_at(expected), hint).has_value());
}

RC_GTEST_PROP(TriangleBVH, ReturnsEachTriangleByItsIndexInTheMesh, ()) {
  const Shape shape = any_soup(300);
  const TriangleBVH tree(shape);
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const Triangle& stored = tree.triangle(static_cast<std::int32_t>(f));
    const Triangle expected = triangle_of(shape, f);
    RC_ASSERT(stored.a == expected.a);
    RC_ASSERT(stored.b == expected.b);
    RC_ASSERT(stored.c == expected.c);
  }
}

/// Whether a point is in a ball and a cone.
bool is_within(const Ball& ball, const Cone& cone, const Eigen::Vector3d& point) {
  const Eigen::Vector3d from_apex = point - cone.apex;
  return (point - ball.centre).norm() <= ball.radius && from_apex.dot(cone.axis) >= cone.cosine * from_apex.norm();
}

RC_GTEST_PROP(TriangleBVH, VisitsFacingTrianglesInTheIntersectionOfABallAndACone, ()) {
  const auto fraction = [] { return *rc::gen::inRange(0, 100) / 100.0; };
  const Shape shape = any_soup(300);
  const TriangleBVH tree(shape);
  const Cone cone{.apex = any_query(shape),
                  .axis = (random_point() + Eigen::Vector3d(0, 0, 2)).normalized(),
                  .cosine = fraction(),
                  .min_normal_cosine = 2 * fraction() - 1,
                  .faces_away = *rc::gen::arbitrary<bool>()};
  const Ball whole{.centre = any_query(shape), .radius = 2 * fraction()};
  std::vector<int> found(static_cast<std::size_t>(shape.triangles.rows()));
  Ball ball = whole;
  tree.search(cone, ball, [&](std::int32_t f, const Ball&) {
    if (f >= 0) ++found[static_cast<std::size_t>(f)];
  });
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const auto [a, b, c] = triangle_of(shape, f);
    const Eigen::Vector3d normal = (b - a).cross(c - a).stableNormalized();
    const double cosine = normal.dot(cone.axis) * (cone.faces_away && normal.dot(a - cone.apex) < 0 ? -1 : 1);
    RC_ASSERT(found[static_cast<std::size_t>(f)] <= 1);
    if ((cone.faces_away ? cosine : std::abs(cosine)) < cone.min_normal_cosine) continue;
    for (const Eigen::Vector3d& point : {a, b, c, Eigen::Vector3d((a + b + c) / 3)}) {
      RC_ASSERT(found[static_cast<std::size_t>(f)] == 1 || !is_within(whole, cone, point));
    }
  }
}

TEST(TriangleBVH, FindsNoClosestPointWithoutTriangles) {
  const TriangleBVH tree{Shape{}};
  EXPECT_FALSE(tree.closest({0, 0, 0}).has_value());
}

TEST(TriangleBVH, FindsTheDistanceToThousandsOfCoincidentTriangles) {
  Shape shape = soup_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  shape.triangles = Triangles(shape.triangles.replicate(5000, 1));
  const TriangleBVH tree(shape);
  EXPECT_DOUBLE_EQ(tree.closest({0.25, 0.25, 2})->distance, 2);
}

/// Points of a cloud are treated as degenerate triangles.
RC_GTEST_PROP(TriangleBVH, FindsTheClosestPointOfACloud, ()) {
  Shape cloud{.vertices = any_soup(100).vertices, .triangles = {}};
  const TriangleBVH tree(cloud);
  const Eigen::Vector3d x = any_query(cloud);
  const double expected = std::sqrt((cloud.vertices.rowwise() - x.transpose()).rowwise().squaredNorm().minCoeff());
  const auto found = tree.closest(x);
  RC_ASSERT(found.has_value());
  RC_ASSERT(std::abs(found->distance - expected) <= tolerance_at(expected));
  RC_ASSERT(found->point == Eigen::Vector3d(cloud.vertices.row(found->triangle).transpose()));
}

/// Few and large triangles in one leaf; the nearest is seldom that with the nearest plane or corner.
TEST(TriangleBVH, FindsTheClosestOfAFewLargeTriangles) {
  RandomNumbers random(1);
  const auto random_row = [&] {
    return Eigen::RowVector3d{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  };
  for (int soup = 0; soup < 20; ++soup) {
    Shape shape;
    shape.vertices.resize(15, 3);
    for (Eigen::Index v = 0; v < shape.vertices.rows(); ++v) shape.vertices.row(v) = random_row();
    shape.triangles.resize(5, 3);
    for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) shape.triangles.row(f) << 3 * f, 3 * f + 1, 3 * f + 2;
    const TriangleBVH tree(shape);
    for (int query = 0; query < 50; ++query) {
      const Eigen::Vector3d x = random_row().transpose();
      const double expected = distance_to_all(shape, x);
      EXPECT_NEAR(tree.closest(x)->distance, expected, tolerance_at(expected));
    }
  }
}

}  // namespace

}  // namespace shapegauge
