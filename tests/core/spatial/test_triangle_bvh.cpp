#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <optional>
#include <rapidcheck/gtest.h>
#include <vector>

#include "shapegauge/core/spatial/triangle_bvh.h"
#include "tests/core/spatial/random_triangle.h"
#include "tests/core/spatial/soups.h"
#include "tests/support/test_shapes.h"

/// The tree against all triangles tried in turn, on soups that trees find hard.
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

/// A place in the soup, near it, or at a corner of it.
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

RC_GTEST_PROP(TriangleBVH, FindsNothingBeyondTheLimit, ()) {
  const Shape shape = any_soup(300);
  const TriangleBVH tree(shape);
  const Eigen::Vector3d x = any_query(shape);
  const double expected = distance_to_all(shape, x);
  const int hint = *rc::gen::inRange(-1, static_cast<int>(shape.triangles.rows()));
  RC_ASSERT(!tree.closest(x, expected * 0.999, hint).has_value());
  RC_ASSERT(tree.closest(x, expected + tolerance_at(expected), hint).has_value());
  RC_ASSERT(!tree.any_within(x, expected * 0.999 - 1e-6, hint).has_value());
  const double reach = expected * 1.001 + *rc::gen::inRange(1, 1000) / 1000.0;
  const auto within = tree.any_within(x, reach, hint);
  RC_ASSERT(within.has_value());
  RC_ASSERT(distance_to(shape, *within, x) < reach + tolerance_at(reach));
}

RC_GTEST_PROP(TriangleBVH, KeepsTheTrianglesAndTheirNumbers, ()) {
  const Shape shape = any_soup(300);
  const TriangleBVH tree(shape);
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const Triangle& kept = tree.triangle(static_cast<std::int32_t>(f));
    const Triangle given = triangle_of(shape, f);
    RC_ASSERT(kept.a == given.a);
    RC_ASSERT(kept.b == given.b);
    RC_ASSERT(kept.c == given.c);
  }
}

TEST(TriangleBVH, OfNoTrianglesAnswersNothing) {
  const TriangleBVH tree{Shape{}};
  EXPECT_FALSE(tree.closest({0, 0, 0}).has_value());
  EXPECT_FALSE(tree.any_within({0, 0, 0}, 1).has_value());
  EXPECT_EQ(tree.ray_parity({0, 0, 0}, {1, 0, 0})->count, 0);
}

TEST(TriangleBVH, CopesWithManyTrianglesInOnePlace) {
  Shape shape = soup_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  shape.triangles = Triangles(shape.triangles.replicate(5000, 1));
  const TriangleBVH tree(shape);
  EXPECT_DOUBLE_EQ(tree.closest({0.25, 0.25, 2})->distance, 2);
}

/// A closed box of twelve triangles from (0, 0, 0) to (1, 1, 1).
Shape unit_box() {
  Shape box;
  box.vertices.resize(8, 3);
  for (int i = 0; i < 8; ++i) box.vertices.row(i) << i % 2, (i / 2) % 2, i / 4;
  box.triangles.resize(12, 3);
  box.triangles << 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3,
      7, 5;
  return box;
}

TEST(TriangleBVH, CountsTheCrossingsOfARay) {
  const TriangleBVH tree(unit_box());
  const Eigen::Vector3d direction = Eigen::Vector3d(1, 0.31, 0.17).normalized();
  EXPECT_EQ(tree.ray_parity({-1, 0.2, 0.3}, direction)->count, 2);
  EXPECT_EQ(tree.ray_parity({-1, 0.2, 0.3}, direction)->balance, 0);
  EXPECT_EQ(tree.ray_parity({0.3, 0.2, 0.3}, direction)->count, 1);
  EXPECT_EQ(tree.ray_parity({0.3, 0.2, 0.3}, direction)->balance, 1);
  EXPECT_EQ(tree.ray_parity({2, 0.2, 0.3}, direction)->count, 0);
  // Straight through the corner at the origin: nothing can be said.
  const Eigen::Vector3d diagonal = Eigen::Vector3d(1, 1.5, 2).normalized();
  EXPECT_EQ(tree.ray_parity(-diagonal, diagonal).has_value(), false);
}

RC_GTEST_PROP(TriangleBVH, ClosestToEachIsTheClosestOfEach, ()) {
  const Shape shape = any_soup(600);
  const TriangleBVH tree(shape);
  const Eigen::Vector3d about = any_query(shape);
  std::vector<Eigen::Vector3d> points;
  const int count = *rc::gen::inRange(1, static_cast<int>(TriangleBVH::most_points_at_once) + 1);
  for (int i = 0; i < count; ++i) points.push_back(about + 0.2 * random_point());
  const double reach = *rc::gen::inRange(1, 200) / 100.0;
  const double enough = *rc::gen::element(0.0, reach / 2);
  const auto found = tree.closest_to_each(points, reach, enough);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (i >= points.size()) {
      RC_ASSERT(found[i].triangle == -1);
      continue;
    }
    constexpr double tolerance = 1e-5;  // ten times that of one query: the distance is in single precision, too
    const double expected = distance_to_all(shape, points[i]);
    if (expected > reach + tolerance) RC_ASSERT(found[i].triangle == -1);
    if (expected < reach - tolerance) RC_ASSERT(found[i].triangle >= 0);
    if (found[i].triangle < 0) continue;
    const double distance = static_cast<double>(found[i].distance);
    RC_ASSERT(std::abs(distance_to(shape, found[i].triangle, points[i]) - distance) < tolerance);
    RC_ASSERT(distance > expected - tolerance);
    RC_ASSERT(distance < enough || distance < expected + tolerance);
  }
}

RC_GTEST_PROP(TriangleBVH, CountsTheCrossingsOfEveryTriangle, ()) {
  const Shape shape = any_soup(300);
  const TriangleBVH tree(shape);
  int compared = 0;
  for (int i = 0; i < 10; ++i) {
    const Eigen::Vector3d x = random_point();
    // Towards a corner's neighbourhood, so that most rays meet something.
    const Eigen::Vector3d target =
        shape.vertices.row(i * 31 % shape.vertices.rows()).transpose() + 0.1 * random_point();
    if (!((target - x).norm() > 0.01)) continue;
    const Eigen::Vector3d direction = (target - x).normalized();
    RayParity expected;
    bool sure = true;
    for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
      const RayMeeting one = meeting_of(triangle_of(shape, f), x, direction, 1e-7);
      sure = sure && one.sure;
      expected.count += one.crosses ? 1 : 0;
      expected.balance += one.crosses ? (one.along_normal ? 1 : -1) : 0;
    }
    const std::optional<RayParity> found = tree.ray_parity(x, direction);
    if (!sure || !found) continue;
    ++compared;
    RC_ASSERT(found->count == expected.count);
    RC_ASSERT(found->balance == expected.balance);
  }
  RC_CLASSIFY(compared > 5);
}

/// Odd inside and even outside, however parts overlap; the balance says how often one is inside.
RC_GTEST_PROP(TriangleBVH, ParityTellsTheInsideOfClosedMeshes, ()) {
  const Eigen::Vector3d centre = 0.3 * random_point();
  const Shape ball = test::transformed(test::sphere(0.5, 3), 1, test::rotation(3), centre);
  const Shape other = test::sphere(0.4, 2);
  const TriangleBVH tree(test::joined({ball, other}));
  const Eigen::Vector3d x = random_point();
  const double to_ball = (x - centre).norm();
  const double to_other = x.norm();
  // Between a sphere and its mesh nothing is known; the faces lie less than 1 and 2 % of the radius below it.
  RC_PRE((to_ball > 0.5 || to_ball < 0.49) && (to_other > 0.4 || to_other < 0.37));
  const int inside = (to_ball < 0.5 ? 1 : 0) + (to_other < 0.4 ? 1 : 0);
  int answered = 0;
  for (int i = 0; i < 5; ++i) {
    const Eigen::Vector3d towards = random_point();
    if (!(towards.norm() > 0.01)) continue;
    const std::optional<RayParity> parity = tree.ray_parity(x, towards.normalized());
    if (!parity) continue;
    ++answered;
    RC_ASSERT(parity->balance == inside);
    RC_ASSERT((parity->count - inside) % 2 == 0);
    RC_ASSERT(parity->count >= inside);
  }
  RC_ASSERT(answered > 0);
}

/// A cloud's points are found as triangles of no size.
RC_GTEST_PROP(TriangleBVH, FindsTheClosestPointOfACloud, ()) {
  Shape cloud;
  cloud.vertices = any_soup(100).vertices;
  const TriangleBVH tree(cloud);
  const Eigen::Vector3d x = any_query(cloud);
  const double expected = std::sqrt((cloud.vertices.rowwise() - x.transpose()).rowwise().squaredNorm().minCoeff());
  const auto found = tree.closest(x);
  RC_ASSERT(found.has_value());
  RC_ASSERT(std::abs(found->distance - expected) <= tolerance_at(expected));
  RC_ASSERT(found->point == Eigen::Vector3d(cloud.vertices.row(found->triangle).transpose()));
}

}  // namespace

}  // namespace shapegauge
