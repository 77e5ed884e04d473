#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <rapidcheck/gtest.h>

#include "shapegauge/core/spatial/triangle_bvh.h"
#include "tests/core/spatial/random_triangle.h"

namespace shapegauge {

namespace {

/// Triangles at random places, of sizes over several orders of magnitude, every tenth degenerate.
Shape random_soup(int triangles, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> coordinate(-0.5, 0.5);
  std::uniform_real_distribution<double> exponent(-4, -0.5);
  Shape shape;
  shape.vertices.resize(3 * triangles, 3);
  shape.triangles.resize(triangles, 3);
  for (int f = 0; f < triangles; ++f) {
    const Eigen::RowVector3d centre(coordinate(generator), coordinate(generator), coordinate(generator));
    const double size = std::pow(10, exponent(generator));
    for (int k = 0; k < 3; ++k) {
      const Eigen::RowVector3d offset(coordinate(generator), coordinate(generator), coordinate(generator));
      shape.vertices.row(3 * f + k) = centre + size * offset;
      shape.triangles(f, k) = 3 * f + k;
    }
    if (f % 10 == 0) shape.vertices.row(3 * f + 1) = shape.vertices.row(3 * f);
    if (f % 20 == 0) shape.vertices.row(3 * f + 2) = shape.vertices.row(3 * f);
  }
  return shape;
}

double distance_to_all(const TriangleBVH& tree, int triangles, const Eigen::Vector3d& x) {
  double distance = std::numeric_limits<double>::infinity();
  for (int f = 0; f < triangles; ++f) distance = std::min(distance, (closest_point(tree.triangle(f), x) - x).norm());
  return distance;
}

RC_GTEST_PROP(TriangleBVH, FindsTheClosestTriangleOfASoup, ()) {
  const int triangles = *rc::gen::inRange(1, 300);
  const Shape shape = random_soup(triangles, *rc::gen::arbitrary<unsigned>());
  const TriangleBVH tree(shape);
  const auto coordinate = [] { return *rc::gen::inRange(-2000, 2001) / 1000.0; };
  const Eigen::Vector3d x(coordinate(), coordinate(), coordinate());
  const double expected = distance_to_all(tree, triangles, x);
  const auto found = tree.closest(x);
  RC_ASSERT(found.has_value());
  RC_ASSERT(found->distance >= expected);
  RC_ASSERT(found->distance <= expected + 1e-6 * (1 + expected));
  RC_ASSERT(std::abs((found->point - x).norm() - found->distance) <= 1e-12);
  const int hint = *rc::gen::inRange(0, triangles);
  RC_ASSERT(std::abs(tree.closest(x, INFINITY, hint)->distance - expected) <= 1e-6 * (1 + expected));
  RC_ASSERT(!tree.closest(x, expected * 0.999).has_value());
  RC_ASSERT(!tree.any_within(x, expected * 0.999 - 1e-6).has_value());
  RC_ASSERT(tree.any_within(x, expected * 1.001 + 1e-6).has_value());
}

TEST(TriangleBVH, OfNoTrianglesAnswersNothing) {
  const TriangleBVH tree{Shape{}};
  EXPECT_FALSE(tree.closest({0, 0, 0}).has_value());
  EXPECT_FALSE(tree.any_within({0, 0, 0}, 1).has_value());
  EXPECT_EQ(tree.ray_parity({0, 0, 0}, {1, 0, 0})->count, 0);
}

TEST(TriangleBVH, CopesWithManyTrianglesInOnePlace) {
  Shape shape = random_soup(1, 7);
  shape.vertices.row(0) << 0, 0, 0;
  shape.vertices.row(1) << 1, 0, 0;
  shape.vertices.row(2) << 0, 1, 0;
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
  const TriangleBVH tree(random_soup(*rc::gen::inRange(1, 600), *rc::gen::inRange(1U, 1000U)));
  const Eigen::Vector3d about = random_point();
  std::vector<Eigen::Vector3d> points;
  const int count = *rc::gen::inRange(1, 9);
  for (int i = 0; i < count; ++i) points.push_back(about + 0.2 * random_point());
  const double reach = *rc::gen::inRange(1, 200) / 100.0;
  const double enough = *rc::gen::element(0.0, reach / 2);
  const auto found = tree.closest_to_each(points, reach, enough);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto one = tree.closest(points[i], reach);
    RC_ASSERT((found[i].triangle >= 0) == one.has_value());
    if (!one) continue;
    const double distance = static_cast<double>(found[i].distance);
    RC_ASSERT(distance < enough || std::abs(distance - one->distance) < 1e-5);
    RC_ASSERT(distance > one->distance - 1e-5);
    RC_ASSERT(std::abs((closest_point(tree.triangle(found[i].triangle), points[i]) - points[i]).norm() - distance) <
              1e-5);
  }
}

}  // namespace

}  // namespace shapegauge
