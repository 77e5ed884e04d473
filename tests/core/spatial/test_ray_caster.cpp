// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <rapidcheck/gtest.h>
#include <span>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <vector>

#include "shapegauge/core/spatial/ray_caster.h"
#include "tests/core/spatial/soups.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

Eigen::Vector3d random_point_within(std::mt19937& random, double extent) {
  std::uniform_real_distribution<double> uniform(-extent, extent);
  const double x = uniform(random);
  const double y = uniform(random);
  return {x, y, uniform(random)};
}

/// Tolerance of single precision for shapes of size 1.
constexpr double unsure = 1e-5;

struct Expected {
  RayMeeting first;            ///< with the triangle that the ray crosses first; or with none
  std::int32_t triangle = -1;  ///< which
  bool sure = true;            ///< false if the hit depends on rounding
  bool other_as_near = false;  ///< another triangle is crossed at about the same distance
};

Expected brute_force(const Shape& shape, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                     std::int32_t skipped) {
  Expected expected;
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    if (f == skipped) continue;
    const RayMeeting meeting = meeting_of(triangle_of(shape, f), origin, direction, unsure);
    expected.sure = expected.sure && meeting.sure;
    if (!meeting.crosses) continue;
    const double further = meeting.distance - expected.first.distance;
    const bool is_first = expected.triangle < 0 || further < 0;
    if (expected.triangle >= 0 && std::abs(further) < unsure) {
      expected.other_as_near = true;
    } else if (is_first) {
      expected.other_as_near = false;
    }
    if (!is_first) continue;
    expected.first = meeting;
    expected.triangle = static_cast<std::int32_t>(f);
  }
  return expected;
}

RC_GTEST_PROP(RayCaster, MatchesExhaustiveSearchOverTriangles, (unsigned seed)) {
  std::mt19937 random(seed);
  const Shape soup = any_soup(100);
  const RayCaster caster(soup, seed % 2 == 0 ? EdgeHandling::robust : EdgeHandling::fast);
  int compared = 0;
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d origin = random_point_within(random, 1);
    const Eigen::Vector3d corner = soup.vertices.row(i * 37 % soup.vertices.rows());
    const Eigen::Vector3d way = corner + random_point_within(random, 0.1) - origin;
    if (!(way.norm() > 0.01)) continue;
    const Eigen::Vector3d direction = way.normalized();
    std::int32_t skipped = -1;
    for (int pass = 0; pass < 2; ++pass) {
      const Expected expected = brute_force(soup, origin, direction, skipped);
      if (!expected.sure) break;
      ++compared;
      const std::array<std::int32_t, 1> skip = {skipped};
      const RayHit hit = caster.first_hit(origin, direction, skip);
      RC_ASSERT(static_cast<bool>(hit) == (expected.triangle >= 0));
      if (!hit) break;
      RC_ASSERT(hit.triangle == expected.triangle || (expected.other_as_near && hit.triangle != skipped));
      const RayMeeting met = meeting_of(triangle_of(soup, hit.triangle), origin, direction, unsure);
      RC_ASSERT(met.crosses);
      RC_ASSERT(hit.leaving == met.along_normal);
      RC_ASSERT(std::abs(hit.distance - met.distance) < 1e-9);
      RC_ASSERT(hit.distance < expected.first.distance + unsure);
      skipped = hit.triangle;
    }
  }
  RC_CLASSIFY(compared > 50);
}

TEST(RayCaster, FindsTheHitOfEveryRayThroughAnEdgeOrVertex) {
  const Shape sphere = test::transformed(test::sphere(1, 3), 3, test::rotation(5), {7, -2, 1});
  const Eigen::Vector3d centre(7, -2, 1);
  const RayCaster caster(sphere);
  for (Eigen::Index f = 0; f < sphere.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d a = sphere.vertices.row(sphere.triangles(f, k));
      const Eigen::Vector3d b = sphere.vertices.row(sphere.triangles(f, (k + 1) % 3));
      for (const double part : {0.0, 0.3, 0.5}) {
        const Eigen::Vector3d target = a + part * (b - a);
        const RayHit hit = caster.first_hit(centre, (target - centre).normalized());
        ASSERT_TRUE(hit);
        EXPECT_TRUE(hit.leaving);
        EXPECT_NEAR(hit.distance, (target - centre).norm(), 1e-7);  // the neighbour's plane, within single precision
      }
    }
  }
}

/// Directions to corners, to middles of edges and to interiors of the shape's triangles.
std::vector<Eigen::Vector3d> directions_to(const Shape& shape, const Eigen::Vector3d& origin) {
  std::vector<Eigen::Vector3d> directions;
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const Eigen::Vector3d a = shape.vertices.row(shape.triangles(f, 0));
    const Eigen::Vector3d b = shape.vertices.row(shape.triangles(f, 1));
    const Eigen::Vector3d c = shape.vertices.row(shape.triangles(f, 2));
    for (const Eigen::Vector3d& target : {a, ((a + b) / 2).eval(), ((a + b + c) / 3).eval()}) {
      directions.push_back((target - origin).normalized());
    }
  }
  return directions;
}

/// Nested spheres; the outer one appears twice, and once more flipped.
Shape nested_spheres(int subdivisions) {
  const Shape outer = test::sphere(1, subdivisions);
  const Shape shape = test::joined({outer, test::sphere(0.4, 2), test::flipped(outer), outer});
  return test::transformed(shape, 3, test::rotation(5), {7, -2, 1});
}

std::vector<RayHit> hits_of(const Shape& shape, EdgeHandling edge_handling, const Eigen::Vector3d& origin,
                            std::span<const Eigen::Vector3d> directions, std::span<const std::int32_t> skipped = {}) {
  std::vector<RayHit> hits(directions.size());
  RayCaster(shape, edge_handling).first_hits(origin, directions, skipped, hits);
  return hits;
}

TEST(RayCaster, BatchOfRaysGivesTheHitsOfSingleRays) {
  const Shape shape = nested_spheres(2);
  const Eigen::Vector3d origin(7.3, -1, -1);
  std::vector<Eigen::Vector3d> directions = directions_to(shape, origin);
  directions.emplace_back(directions.front());
  const std::array<std::int32_t, 3> skipped = {12, 400, 3};
  for (const EdgeHandling edge_handling : {EdgeHandling::robust, EdgeHandling::fast}) {
    const RayCaster caster(shape, edge_handling);
    for (const std::size_t count : {std::size_t{2}, std::size_t{0}, skipped.size()}) {
      const std::span<const std::int32_t> without = std::span(skipped).first(count);
      const std::vector<RayHit> hits = hits_of(shape, edge_handling, origin, directions, without);
      for (std::size_t i = 0; i < directions.size(); ++i) {
        const RayHit hit = caster.first_hit(origin, directions[i], without);
        EXPECT_EQ(hits[i].triangle, hit.triangle);
        EXPECT_EQ(hits[i].distance, hit.distance);
        EXPECT_EQ(hits[i].leaving, hit.leaving);
        EXPECT_EQ(std::ranges::count(without, hits[i].triangle), 0);
      }
    }
  }
}

TEST(RayCaster, GivesTheSameHitsOnAnyNumberOfThreads) {
  const Shape shape = nested_spheres(5);  // enough triangles for a multithreaded build by Embree
  const Eigen::Vector3d origin(7.3, -1, -1);
  const std::vector<Eigen::Vector3d> directions = directions_to(test::sphere(1, 4), {0.1, 0.2, 0.3});
  const tbb::global_control more_threads_than_cores(tbb::global_control::max_allowed_parallelism, 8);
  for (const EdgeHandling edge_handling : {EdgeHandling::robust, EdgeHandling::fast}) {
    tbb::task_arena alone(1);
    const std::vector<RayHit> expected =
        alone.execute([&] { return hits_of(shape, edge_handling, origin, directions); });
    for (const int threads : {2, 8}) {
      tbb::task_arena arena(threads);
      const std::vector<RayHit> hits = arena.execute([&] { return hits_of(shape, edge_handling, origin, directions); });
      for (std::size_t i = 0; i < hits.size(); ++i) {
        ASSERT_EQ(hits[i].triangle, expected[i].triangle);
        ASSERT_EQ(hits[i].distance, expected[i].distance);
      }
    }
  }
}

TEST(RayCaster, IgnoresTrianglesThatContainTheOrigin) {
  const Shape sphere = nested_spheres(3);
  const Eigen::Vector3d centre(7, -2, 1);
  for (const EdgeHandling edge_handling : {EdgeHandling::robust, EdgeHandling::fast}) {
    const RayCaster caster(sphere, edge_handling);
    for (Eigen::Index f = 0; f < 1280; ++f) {
      Eigen::Vector3d origin = Eigen::Vector3d::Zero();
      for (int k = 0; k < 3; ++k) origin += sphere.vertices.row(sphere.triangles(f, k)).transpose() / 3;
      EXPECT_GT(caster.first_hit(origin, (centre - origin).normalized()).distance, 1.5) << f;
    }
  }
}

TEST(RayCaster, HitsDoNotDependOnScaleAndPosition) {
  const Shape torus = test::torus(3, 1, 30, 60);
  const Eigen::Vector3d origin(3.2, 0.1, 0.2);
  const Eigen::Vector3d direction = Eigen::Vector3d(0.3, 0.2, -0.9).normalized();
  const RayHit expected = RayCaster(torus).first_hit(origin, direction);
  ASSERT_TRUE(expected);
  for (const double scale : {1e-150, 1e-30, 1e-3, 1e30, 1e150}) {
    const Eigen::Vector3d move = scale * Eigen::Vector3d(1000, -2000, 500);
    const Shape moved = test::transformed(torus, scale, Eigen::Matrix3d::Identity(), move);
    const RayHit hit = RayCaster(moved).first_hit(scale * origin + move, direction);
    EXPECT_EQ(hit.triangle, expected.triangle) << scale;
    EXPECT_NEAR(hit.distance / scale, expected.distance, 1e-11) << scale;
    EXPECT_EQ(hit.leaving, expected.leaving) << scale;
  }
}

TEST(RayCaster, ReturnsTheFirstOfTrianglesAtEqualDistance) {
  const Shape sheet = test::box({1, 1, 1}, 1);
  const Shape sheets = test::joined({sheet, sheet, test::flipped(sheet)});
  for (const EdgeHandling edge_handling : {EdgeHandling::robust, EdgeHandling::fast}) {
    const RayHit alone = RayCaster(sheet, edge_handling).first_hit({0.1, 0.2, 5}, {0, 0, -1});
    const RayHit hit = RayCaster(sheets, edge_handling).first_hit({0.1, 0.2, 5}, {0, 0, -1});
    EXPECT_EQ(hit.triangle, alone.triangle);
    EXPECT_FALSE(hit.leaving);
  }
}

TEST(RayCaster, IgnoresHitsOnTrianglesListedAsSkipped) {
  const Shape box = test::box({1, 1, 1}, 1);
  const RayCaster caster(box);
  std::vector<std::int32_t> skipped;
  for (int i = 0; i < 2; ++i) skipped.push_back(caster.first_hit({0.1, 0.2, 5}, {0, 0, -1}, skipped).triangle);
  EXPECT_NE(skipped[0], skipped[1]);
  EXPECT_FALSE(caster.first_hit({0.1, 0.2, 5}, {0, 0, -1}, skipped));
}

TEST(RayCaster, IgnoresUnusedVerticesAndDegenerateTriangles) {
  Shape box = test::box({1, 1, 1}, 1);
  const Eigen::Index triangles = box.triangles.rows();
  box.vertices.conservativeResize(box.vertices.rows() + 1, 3);
  box.vertices.bottomRows<1>().setConstant(1e12);
  box.triangles.conservativeResize(triangles + 1, 3);
  box.triangles.bottomRows<1>() << 0, 1, 1;
  const RayHit hit = RayCaster(box).first_hit({0.1, 0.2, 0}, {0, 0, 1});
  EXPECT_NEAR(hit.distance, 0.5, 1e-14);
}

TEST(RayCaster, RaysHaveNoHitsInAnEmptyShape) {
  EXPECT_FALSE(RayCaster(Shape{}).first_hit({0, 0, 0}, {0, 0, 1}));
  const std::array<Eigen::Vector3d, 2> directions = {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ()};
  for (const RayHit& hit : hits_of(Shape{}, EdgeHandling::fast, {0, 0, 0}, directions)) EXPECT_FALSE(hit);
  EXPECT_TRUE(hits_of(test::sphere(1, 1), EdgeHandling::robust, {0, 0, 0}, {}).empty());
  Shape point = test::box({0, 0, 0}, 1);
  EXPECT_FALSE(RayCaster(point).first_hit({1, 1, 1}, {0, 0, 1}));
  EXPECT_FALSE(RayCaster(test::sphere(1, 1)).first_hit({0, 0, 3}, {0, 0, 1}));
}

}  // namespace
}  // namespace shapegauge
