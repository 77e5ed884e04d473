#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <rapidcheck/gtest.h>
#include <set>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/core/preparation/gap_size.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

Shape without_faces(Shape shape, const std::set<Eigen::Index>& removed) {
  Triangles kept(shape.triangles.rows() - static_cast<Eigen::Index>(removed.size()), 3);
  Eigen::Index count = 0;
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    if (!removed.contains(f)) kept.row(count++) = shape.triangles.row(f);
  }
  shape.triangles = kept;
  return shape;
}

/// A band of 2 n triangles along the unit circle; with a half turn, a Moebius strip.
Shape band(int n, double width, bool half_turn) {
  Shape shape{Points(2 * n, 3), Triangles(2 * n, 3)};
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    const double tilt = half_turn ? angle / 2 : 0;
    for (const int side : {0, 1}) {
      const double across = (side - 0.5) * width;
      const double radius = 1 + across * std::sin(tilt);
      shape.vertices.row(2 * i + side) << radius * std::cos(angle), radius * std::sin(angle), across * std::cos(tilt);
    }
    const bool crossed = half_turn && i == n - 1;
    const std::int32_t next = 2 * ((i + 1) % n);
    const std::int32_t low = next + (crossed ? 1 : 0);
    const std::int32_t high = next + (crossed ? 0 : 1);
    shape.triangles.row(2 * i) << 2 * i, low, high;
    shape.triangles.row(2 * i + 1) << 2 * i, high, 2 * i + 1;
  }
  return shape;
}

double total_length(const std::vector<BoundaryLoop>& loops) {
  double sum = 0;
  for (const BoundaryLoop& loop : loops) sum += loop.length;
  return sum;
}

TEST(BoundaryLoops, NoneOfClosedMeshesAndClouds) {
  EXPECT_TRUE(boundary_loops(test::torus(2, 0.7, 8, 12)).empty());
  EXPECT_TRUE(boundary_loops(test::soup(test::box({1, 2, 3}, 3))).empty());
  EXPECT_TRUE(boundary_loops({test::sphere(1, 2).vertices, {}}).empty());
  EXPECT_TRUE(boundary_loops({}).empty());
}

TEST(BoundaryLoops, OneForEachFaceRemovedFromABox) {
  const Shape box = test::box({2, 2, 2}, 4);  // cells of 0.5
  for (const std::set<Eigen::Index>& removed : {std::set<Eigen::Index>{0}, {0, 40, 100}, {5, 70, 75, 130, 191}}) {
    const std::vector<BoundaryLoop> loops = boundary_loops(without_faces(box, removed));
    ASSERT_EQ(loops.size(), removed.size());
    for (const BoundaryLoop& loop : loops) {
      EXPECT_EQ(loop.vertices.size(), 3U);
      EXPECT_NEAR(loop.length, 1 + std::sqrt(0.5), 1e-12);
      EXPECT_NEAR(loop.vector_area.norm(), 0.125, 1e-12);
      EXPECT_NEAR(loop.radius_bound(), std::sqrt(0.125 / std::numbers::pi), 1e-12);
    }
  }
}

TEST(BoundaryLoops, HolesThatTouchAtAVertexPart) {
  const Shape box = test::box({2, 2, 2}, 4);
  // A side's cells come one after the other, two triangles each: (0, 0) and (1, 1) touch at a corner.
  const std::vector<BoundaryLoop> loops = boundary_loops(without_faces(box, {0, 1, 10, 11}));
  ASSERT_EQ(loops.size(), 2U);
  for (const BoundaryLoop& loop : loops) {
    EXPECT_EQ(loop.vertices.size(), 4U);
    EXPECT_NEAR(loop.length, 2, 1e-12);
    EXPECT_NEAR(loop.vector_area.norm(), 0.25, 1e-12);
  }
}

TEST(BoundaryLoops, OfAnOpenCylinderAreItsTwoCircles) {
  constexpr int n = 64;
  for (const Shape& cylinder : {band(n, 3, false), test::soup(band(n, 3, false))}) {
    const std::vector<BoundaryLoop> loops = boundary_loops(cylinder);
    ASSERT_EQ(loops.size(), 2U);
    for (const BoundaryLoop& loop : loops) {
      EXPECT_EQ(loop.vertices.size(), static_cast<std::size_t>(n));
      EXPECT_NEAR(loop.length, 2 * n * std::sin(std::numbers::pi / n), 1e-9);
      EXPECT_NEAR(loop.vector_area.norm(), n * std::sin(std::numbers::pi / n) * std::cos(std::numbers::pi / n), 1e-9);
    }
  }
}

TEST(BoundaryLoops, OfAMoebiusStripIsOneTwiceAround) {
  const std::vector<BoundaryLoop> loops = boundary_loops(band(64, 0.2, true));
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_EQ(loops[0].vertices.size(), 128U);
  EXPECT_NEAR(loops[0].length, 4 * std::numbers::pi, 0.1);
}

TEST(BoundaryLoops, OfABookOfPagesCoverEveryBoundaryEdgeOnce) {
  // Pages of one triangle on a common spine: with three pages the spine is no boundary, and two edges of each page are.
  Shape book{Points(5, 3), Triangles(3, 3)};
  book.vertices << 0, 0, 0, 0, 0, 1, 1, 0, 0.5, 0, 1, 0.5, -1, 0, 0.5;
  book.triangles << 0, 1, 2, 0, 1, 3, 0, 1, 4;
  const std::vector<BoundaryLoop> loops = boundary_loops(book);
  ASSERT_EQ(loops.size(), 2U);  // two pages together, and the third closed by its ends
  const double side = std::sqrt(1.25);
  EXPECT_NEAR(total_length(loops), 6 * side + 1, 1e-12);
  std::size_t vertices = 0;
  for (const BoundaryLoop& loop : loops) vertices += loop.vertices.size();
  EXPECT_EQ(vertices, 4U + 3U);
}

TEST(BoundaryLoops, OfACrackedMeshAddUpToItsBoundary) {
  const Shape torus = test::torus(2, 0.7, 30, 60);
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    RandomNumbers random(seed);
    Shape cracked = remove_faces(torus, 0.1 * static_cast<double>(seed), random);
    const std::vector<BoundaryLoop> loops = boundary_loops(cracked);
    const ShapeDiagnostics found = diagnose(cracked);
    std::size_t edges = 0;
    for (const BoundaryLoop& loop : loops) {
      edges += loop.vertices.size();
      std::vector<std::int32_t> vertices = loop.vertices;
      std::ranges::sort(vertices);
      EXPECT_EQ(std::ranges::adjacent_find(vertices), vertices.end());
    }
    EXPECT_EQ(edges, found.boundary_edges);
    EXPECT_NEAR(total_length(loops), found.boundary_length, 1e-9 * found.boundary_length);
    const Shape turned = flip_orientation(cracked, 0.5, random);
    EXPECT_NEAR(total_length(boundary_loops(turned)), found.boundary_length, 1e-9 * found.boundary_length);
    EXPECT_EQ(boundary_loops(turned).size(), loops.size());
  }
}

TEST(BoundaryLoops, RefusesAnUnusableShape) {
  Shape shape = test::sphere(1, 0);
  shape.triangles(3, 1) = -1;
  EXPECT_THROW(boundary_loops(shape), InputError);
}

using Polygon = std::vector<Eigen::Vector2d>;

TEST(InscribedCircle, OfKnownPolygons) {
  EXPECT_NEAR(inscribed_circle_radius({{0, 0}, {4, 0}, {4, 2}, {0, 2}}), 1, 0.01);
  EXPECT_NEAR(inscribed_circle_radius({{0, 0}, {0, 3}, {4, 0}}), 1, 0.01);  // clockwise; the 3-4-5 triangle
  // An L of arms 1 wide: the circle in the corner touches both outer sides and the inner corner.
  const double corner = 2 - std::sqrt(2.0);
  EXPECT_NEAR(inscribed_circle_radius({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}), corner, 0.01 * corner);
  // A slit that runs into a square hole adds to its length, not to its width.
  EXPECT_NEAR(inscribed_circle_radius({{0, 0}, {1, 0}, {1, 0.45}, {9, 0.45}, {9, 0.55}, {1, 0.55}, {1, 1}, {0, 1}}),
              0.5, 0.01);
}

TEST(InscribedCircle, OfNothing) {
  EXPECT_EQ(inscribed_circle_radius({}), 0);
  EXPECT_EQ(inscribed_circle_radius({{1, 1}, {2, 2}}), 0);
  EXPECT_EQ(inscribed_circle_radius({{1, 1}, {2, 2}, {3, 3}}), 0);
}

RC_GTEST_PROP(InscribedCircle, OfAnyTriangleIsTwiceTheAreaByTheLength, ()) {
  const auto coordinate = [] { return *rc::gen::inRange(-1000, 1000) / 100.0; };
  const Polygon triangle{{coordinate(), coordinate()}, {coordinate(), coordinate()}, {coordinate(), coordinate()}};
  const Eigen::Vector2d ab = triangle[1] - triangle[0];
  const Eigen::Vector2d ac = triangle[2] - triangle[0];
  const double doubled_area = std::abs(ab.x() * ac.y() - ab.y() * ac.x());
  const double length = ab.norm() + ac.norm() + (ac - ab).norm();
  const double radius = inscribed_circle_radius(triangle);
  RC_ASSERT(radius * length <= doubled_area * (1 + 1e-9));
  double diagonal = 0;
  for (const Eigen::Vector2d& side : {ab, ac, Eigen::Vector2d(ac - ab)}) diagonal = std::max(diagonal, side.norm());
  // The box's diagonal is at most the root of two times the longest side.
  RC_ASSERT(radius * 1.01 + 1.5e-3 * diagonal >= doubled_area / std::max(length, 1e-9) * (1 - 1e-9));
}

/// A box with cells of 0.5, the side x = -1 open.
Shape open_box() {
  Shape box = test::box({2, 2, 2}, 4);
  box.triangles = box.triangles.bottomRows(box.triangles.rows() - 32).eval();
  return box;
}

TEST(GapSize, OfAClosedMeshIsZero) {
  EXPECT_EQ(gap_size(test::torus(2, 0.7, 8, 12)), 0);
  EXPECT_EQ(gap_size(test::soup(test::box({1, 2, 3}, 3))), 0);
  EXPECT_EQ(gap_size({}), 0);
}

TEST(GapSize, OfASquareOpeningIsItsInscribedCircle) { EXPECT_NEAR(gap_size(open_box()), 1, 1e-12); }

TEST(GapSize, IsTheLargestHolesInscribedCircleUpToTheLimit) {
  const auto triangle_at = [](double x, double size) {
    Shape shape{Points(3, 3), Triangles(1, 3)};
    shape.vertices << x, 0, 0, x + size, 0, 0, x, size, 0;
    shape.triangles << 0, 1, 2;
    return shape;
  };
  const double radius_by_size = 1 / (2 + std::sqrt(2.0));  // 2 (size^2 / 2) / ((2 + sqrt 2) size)
  std::vector<Shape> parts;
  for (const double size : {0.01, 0.3, 0.02, 0.1}) parts.push_back(triangle_at(std::ssize(parts), size));
  const Shape shape = test::joined(parts);
  EXPECT_NEAR(gap_size(shape), 0.3 * radius_by_size, 0.3 * 1e-3);
  EXPECT_NEAR(gap_size(shape, 0.2 * radius_by_size), 0.1 * radius_by_size, 0.1 * 1e-3);
  EXPECT_EQ(gap_size(shape, 0.001 * radius_by_size), 0);
}

TEST(GapSize, OfACloudOnAGridIsTheDistanceToTheSixthNeighbour) {
  Shape grid{Points(900, 3), {}};
  for (int i = 0; i < 900; ++i) grid.vertices.row(i) << i / 30, i % 30, 0;
  // Inside sqrt(2); on the border 2: and the border has more than a thousandth of the points; a corner sqrt(5).
  EXPECT_NEAR(gap_size(grid), std::sqrt(5.0), 1e-12);
}

TEST(GapSize, OfFewPointsReachesTheLast) {
  Points points(3, 3);
  points << 0, 0, 0, 1, 0, 0, 3, 0, 0;
  EXPECT_EQ(gap_size({points, {}}), 3);
  EXPECT_EQ(gap_size({points.topRows(2), {}}), 1);
  EXPECT_EQ(gap_size({points.topRows(1), {}}), 0);
}

TEST(GapSize, GoesWithTheScaleAndFallsWithDensity) {
  const Shape sphere = test::sphere(1, 4);
  const Shape cloud = test::random_points(sphere, 2000, 1);
  const double gap = gap_size(cloud);
  EXPECT_NEAR(gap_size(test::transformed(cloud, 1e30, test::rotation(1), {0, 0, 0})), 1e30 * gap, 1e21 * gap);
  // Four times the points, half of the distances.
  EXPECT_NEAR(gap_size(test::random_points(sphere, 8000, 1)) / gap, 0.5, 0.1);
}

TEST(GapSize, RefusesAnUnusableShape) {
  Shape cloud{Points::Random(20, 3), {}};
  cloud.vertices(3, 1) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(gap_size(cloud), InputError);
}

}  // namespace

}  // namespace shapegauge
