#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <optional>
#include <random>
#include <rapidcheck/gtest.h>
#include <vector>

#include "shapegauge/core/spatial/triangle_bvh.h"
#include "tests/core/spatial/random_triangle.h"
#include "tests/support/test_shapes.h"

/// The tree against all triangles tried in turn, on soups that trees find hard.
namespace shapegauge {

namespace {

/// A shape of triangles with vertices of their own.
Shape soup_of(const std::vector<Triangle>& triangles) {
  Shape shape;
  shape.vertices.resize(3 * std::ssize(triangles), 3);
  shape.triangles.resize(std::ssize(triangles), 3);
  for (Eigen::Index f = 0; f < std::ssize(triangles); ++f) {
    const Triangle& t = triangles[static_cast<std::size_t>(f)];
    shape.vertices.row(3 * f) = t.a.transpose();
    shape.vertices.row(3 * f + 1) = t.b.transpose();
    shape.vertices.row(3 * f + 2) = t.c.transpose();
    for (int k = 0; k < 3; ++k) shape.triangles(f, k) = static_cast<std::int32_t>(3 * f + k);
  }
  return shape;
}

enum class Soup {
  scattered,   ///< at random places, of sizes over several orders of magnitude, every tenth degenerate
  coplanar,    ///< in one plane that no axis is normal to
  lattice,     ///< corners on a coarse grid: coplanar, touching, degenerate and duplicate triangles abound
  needles,     ///< long, and of hardly any area
  points,      ///< no extent at all
  duplicated,  ///< a few triangles, many times over, either way round
};

const std::vector<Soup> all_soups{Soup::scattered, Soup::coplanar, Soup::lattice,
                                  Soup::needles,   Soup::points,   Soup::duplicated};

class SoupMaker {
 public:
  SoupMaker(Soup kind, unsigned seed) : kind_(kind), generator_(seed) {}

  Shape make(int count) {
    std::vector<Triangle> triangles;
    for (int i = 0; i < count; ++i) {
      if (kind_ == Soup::duplicated && i >= 7) {
        Triangle copy = triangles[static_cast<std::size_t>(i % 7)];
        if (i % 2 == 0) std::swap(copy.b, copy.c);
        triangles.push_back(copy);
      } else {
        triangles.push_back(triangle(i));
      }
    }
    return soup_of(triangles);
  }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }

  Eigen::Vector3d in_cube() {
    const double x = uniform(-0.5, 0.5);
    const double y = uniform(-0.5, 0.5);
    return {x, y, uniform(-0.5, 0.5)};
  }

  Eigen::Vector3d on_lattice() { return (8 * in_cube()).array().round() / 8; }

  Triangle triangle(int i) {
    const Eigen::Vector3d centre = in_cube();
    const double size = std::pow(10, uniform(-4, -0.5));
    Triangle t{centre + size * in_cube(), centre + size * in_cube(), centre + size * in_cube()};
    if (kind_ == Soup::lattice) return {on_lattice(), on_lattice(), on_lattice()};
    if (kind_ == Soup::points) return {centre, centre, centre};
    if (kind_ == Soup::needles) return {centre, centre + in_cube(), centre + 1e-9 * in_cube()};
    if (kind_ == Soup::coplanar) {
      const Eigen::Vector3d normal = Eigen::Vector3d(1, 2, 3).normalized();
      for (Eigen::Vector3d* corner : {&t.a, &t.b, &t.c}) *corner -= normal.dot(*corner) * normal;
    }
    if (i % 10 == 0) t.b = t.a;
    if (i % 20 == 0) t.c = t.a;
    return t;
  }

  Soup kind_;
  std::mt19937 generator_;
};

/// A soup of any kind, of up to so many triangles, for a RapidCheck property.
Shape any_soup(int most) {
  const Soup kind = *rc::gen::elementOf(all_soups);
  const int count = *rc::gen::inRange(1, most);
  return SoupMaker(kind, *rc::gen::inRange(0U, 100'000U)).make(count);
}

Triangle triangle_of(const Shape& shape, Eigen::Index f) {
  return {shape.vertices.row(shape.triangles(f, 0)), shape.vertices.row(shape.triangles(f, 1)),
          shape.vertices.row(shape.triangles(f, 2))};
}

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

/// Whether the ray crosses the triangle: 1 along its normal, -1 against it, 0 not at all; nothing where it passes so
/// close to a side that rounding may decide. By the signs of the volumes that the ray spans with the triangle's sides.
std::optional<int> crossing_of(const Triangle& t, const Eigen::Vector3d& x, const Eigen::Vector3d& direction) {
  constexpr double unsure = 1e-7;
  for (const auto& [p, q] : {std::pair(t.a, t.b), {t.b, t.c}, {t.c, t.a}}) {
    // The distance of the line from the side: both seen along the line.
    const auto across = [&](const Eigen::Vector3d& y) -> Eigen::Vector3d {
      return (y - x) - (y - x).dot(direction) * direction;
    };
    if (closest_point_on_segment(across(p), across(q), Eigen::Vector3d::Zero()).norm() < unsure) return std::nullopt;
  }
  const auto volume = [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
    return direction.dot((p - x).cross(q - x));
  };
  const double u = volume(t.a, t.b);
  const double v = volume(t.b, t.c);
  const double w = volume(t.c, t.a);
  if (!((u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0))) return 0;
  const Eigen::Vector3d normal = (t.b - t.a).cross(t.c - t.a);
  const double along = normal.dot(t.a - x) / normal.dot(direction);
  if (!(std::abs(along) > unsure)) return std::nullopt;
  return along < 0 ? 0 : (u > 0 ? 1 : -1);
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
      const std::optional<int> one = crossing_of(triangle_of(shape, f), x, direction);
      sure = sure && one.has_value();
      expected.count += std::abs(one.value_or(0));
      expected.balance += one.value_or(0);
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
