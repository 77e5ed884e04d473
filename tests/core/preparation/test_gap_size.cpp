#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "shapegauge/core/error.h"
#include "shapegauge/core/preparation/boundary_loops.h"
#include "shapegauge/core/preparation/gap_size.h"
#include "tests/core/random_points.h"
#include "tests/core/test_shapes.h"

namespace shapegauge {
namespace {

/// A box with cells of 0.5, the side x = -1 open.
Shape open_box() {
  Shape box = test_shapes::box({2, 2, 2}, 4);
  box.triangles = box.triangles.bottomRows(box.triangles.rows() - 32).eval();
  return box;
}

TEST(GapSize, OfAClosedMeshIsZero) {
  EXPECT_EQ(gap_size(test_shapes::torus(2, 0.7, 8, 12)), 0);
  EXPECT_EQ(gap_size(test_shapes::soup(test_shapes::box({1, 2, 3}, 3))), 0);
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
  const Shape shape = test_shapes::joined(parts);
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
  const Shape sphere = test_shapes::sphere(1, 4);
  const Shape cloud = test_shapes::random_points(sphere, 2000, 1);
  const double gap = gap_size(cloud);
  EXPECT_NEAR(gap_size(test_shapes::transformed(cloud, 1e30, test_shapes::rotation(1), {0, 0, 0})), 1e30 * gap,
              1e21 * gap);
  // Four times the points, half of the distances.
  EXPECT_NEAR(gap_size(test_shapes::random_points(sphere, 8000, 1)) / gap, 0.5, 0.1);
}

TEST(GapSize, RefusesAnUnusableShape) {
  Shape cloud{Points::Random(20, 3), {}};
  cloud.vertices(3, 1) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(gap_size(cloud), InputError);
}

}  // namespace
}  // namespace shapegauge
