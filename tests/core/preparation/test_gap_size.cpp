// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/preparation/gap_size.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/core/shape/samples.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

/// Removes the triangles whose centroid satisfies a condition.
template <typename Condition>
Shape without(Shape shape, Condition condition) {
  std::vector<Eigen::Index> remaining;
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const auto corner = [&](int k) { return shape.vertices.row(shape.triangles(f, k)).transpose().eval(); };
    if (!condition(Eigen::Vector3d((corner(0) + corner(1) + corner(2)) / 3))) remaining.push_back(f);
  }
  shape.triangles = shape.triangles(remaining, Eigen::all).eval();
  return shape;
}

/// A cube from -1 to 1 with square holes of these half widths, multiples of 1/16, in its top and its bottom.
Shape cube_with_holes(double top, double bottom) {
  return without(test::box({2, 2, 2}, 32), [&](const Eigen::Vector3d& x) {
    const double width = std::max(std::abs(x.x()), std::abs(x.y()));
    return (x.z() > 0.99 && width < top) || (x.z() < -0.99 && width < bottom);
  });
}

/// The six sides of a cube from -1 to 1, each moved outwards by `crack`.
Shape cracked_cube(double crack) {
  std::vector<Shape> sides;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Shape patch = without(test::box({2, 2, 2}, 8), [&](const Eigen::Vector3d& x) { return x[axis] * side < 0.99; });
      patch.vertices.rowwise() += crack * side * Eigen::RowVector3d::Unit(axis);
      sides.push_back(patch);
    }
  }
  return test::joined(sides);
}

/// A cell of the grid in diagonals: at most 1.1 %.
double half_cell(const Shape& shape) { return 0.0055 * bounding_box_diagonal(shape); }

TEST(GapSize, IsZeroForClosedAndEmptyShapes) {
  for (const Shape& shape : {test::torus(2, 0.7, 8, 12), test::soup(test::box({1, 2, 3}, 3)), Shape{}}) {
    EXPECT_EQ(gap_sizes(shape).widest, 0);
    EXPECT_EQ(gap_sizes(shape).closable, 0);
  }
}

TEST(GapSize, IsTheRadiusOfTheLargestCircleInAHole) {
  for (const double hole : {1 / 16.0, 1 / 8.0, 1 / 4.0, 1 / 2.0}) {
    const Shape cube = cube_with_holes(hole, 0);
    EXPECT_NEAR(gap_sizes(cube).widest, hole, half_cell(cube)) << hole;
  }
}

TEST(GapSize, DistinguishesTheWidestGapFromTheWidestClosableGap) {
  const Shape cube = cube_with_holes(1 / 8.0, 1 / 2.0);
  const GapSizes sizes = gap_sizes(cube);
  EXPECT_NEAR(sizes.widest, 1 / 2.0, half_cell(cube));
  EXPECT_EQ(sizes.closable, 0) << "the outside comes in by the wide hole first";
  const Shape two_cubes =
      test::joined({cube_with_holes(1 / 8.0, 0),
                    test::transformed(cube_with_holes(1 / 2.0, 0), 1, Eigen::Matrix3d::Identity(), {3, 0, 0})});
  EXPECT_NEAR(gap_sizes(two_cubes).widest, 1 / 2.0, half_cell(two_cubes));
  EXPECT_NEAR(gap_sizes(two_cubes).closable, 1 / 8.0, half_cell(two_cubes));
}

TEST(GapSize, IsZeroForAnOpenCupOrSheet) {
  const Shape cup = without(test::box({2, 2, 2}, 8), [](const Eigen::Vector3d& x) { return x.z() > 0.99; });
  const Shape sheet = without(test::box({2, 2, 2}, 8), [](const Eigen::Vector3d& x) { return x.z() < 0.99; });
  for (const Shape& shape : {cup, sheet}) EXPECT_EQ(gap_sizes(shape).widest, 0);
}

TEST(GapSize, OfSeparatePatchesIsHalfTheWidthOfTheCracks) {
  for (const double crack : {1e-6, 1e-4, 1e-2, 0.1}) {
    const Shape cube = cracked_cube(crack);
    const double half_width = crack / 2 * std::numbers::sqrt2;
    const GapSizes sizes = gap_sizes(cube);
    EXPECT_NEAR(sizes.widest, half_width, crack > 0.05 ? 1.5 * half_cell(cube) : 0.01 * half_width) << crack;
    EXPECT_EQ(sizes.closable, sizes.widest);
  }
}

TEST(GapSize, ClosableGapIgnoresAWideHoleNextToCracks) {
  const double crack = 1e-3;
  const Shape two = test::joined(
      {cracked_cube(crack), test::transformed(cube_with_holes(1 / 2.0, 0), 1, Eigen::Matrix3d::Identity(), {3, 0, 0})});
  const double half_width = crack / 2 * std::numbers::sqrt2;
  EXPECT_NEAR(gap_sizes(two).widest, 1 / 2.0, half_cell(two));
  EXPECT_NEAR(gap_sizes(two).closable, half_width, 0.01 * half_width);
}

TEST(GapSize, OfSeparateTilesIsHalfTheirDistance) {
  // A closed box of 8 x 8 tiles a side, each shrunk by a thousandth towards its centre.
  Shape tiles = test::soup(test::box({2, 2, 2}, 8));
  for (Eigen::Index first = 0; first < tiles.vertices.rows(); first += 3) {
    auto corners = tiles.vertices.middleRows(first, 3);
    const Eigen::RowVector3d centre = corners.colwise().mean();
    corners = (0.999 * (corners.rowwise() - centre)).rowwise() + centre;
  }
  // Tiles on two sides of a short side are 2/3 of a thousandth of its length apart, and their corners are displaced by
  // half of that along it.
  const double half_width = 0.001 / 4 * std::hypot(2, 1) / 3 / 2;
  EXPECT_NEAR(gap_sizes(tiles).widest, half_width, 0.01 * half_width);
}

TEST(GapSize, IsZeroIfEdgesCoincideWithoutSharedVertices) {
  // The lid has one edge where the wall has eight.
  Shape walls = without(test::box({2, 2, 2}, 8), [](const Eigen::Vector3d& x) { return x.z() > 0.99; });
  Shape lid = without(test::box({2, 2, 2}, 1), [](const Eigen::Vector3d& x) { return x.z() < 0.99; });
  EXPECT_EQ(gap_sizes(test::joined({walls, lid})).widest, 0);
}

TEST(GapSize, OfACloudIncludesTheSizeOfItsHoles) {
  const Shape slab = test::box({2, 2, 0.4}, 1);
  const Shape whole = test::random_points(slab, 20'000, 1);
  const double hole = 0.12;
  Shape holed{Points(0, 3), {}};
  for (const auto& point : whole.vertices.rowwise()) {
    if (point[2] > 0.199 && point.head<2>().norm() < hole) continue;
    holed.vertices.conservativeResize(holed.vertices.rows() + 1, Eigen::NoChange);
    holed.vertices.bottomRows<1>() = point;
  }
  EXPECT_LT(gap_sizes(whole).closable, 0.06);
  EXPECT_NEAR(gap_sizes(holed).closable, hole, half_cell(holed));
  const Samples samples = sample_shape(holed, SampleSite::vertices);
  const auto median_with = [&](double offset) {
    const OffsetSdfResult result = offset_sdf(holed, samples, {.offset = offset / bounding_box_diagonal(holed)});
    Eigen::VectorXd values = result.values;
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return std::pair(values[values.size() / 2], result.outcomes.two_sided);
  };
  const auto closed = median_with(1.1 * gap_sizes(holed).closable);
  EXPECT_NEAR(closed.first, 0.4, 0.01);
  EXPECT_EQ(closed.second, 0U);
  const auto open = median_with(0.8 * hole);
  EXPECT_LT(open.first, 0.01);
  EXPECT_GT(open.second, static_cast<std::size_t>(holed.vertices.rows()) / 2);
}

TEST(GapSize, OfAGridOfPointsIsTheDistanceToTheSixthNeighbour) {
  Shape grid{Points(900, 3), {}};
  for (int i = 0; i < 900; ++i) grid.vertices.row(i) << i / 30, i % 30, 0;
  // Inside sqrt(2); on the border 2: and the border has more than a thousandth of the points; a corner sqrt(5).
  EXPECT_NEAR(gap_sizes(grid).closable, std::sqrt(5.0), 1e-12);
}

TEST(GapSize, OfFewPointsIsTheirLargestDistance) {
  const Points points{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}};
  EXPECT_EQ(gap_sizes({points, {}}).closable, 3);
  EXPECT_EQ(gap_sizes({points.topRows(2), {}}).closable, 1);
  EXPECT_EQ(gap_sizes({points.topRows(1), {}}).closable, 0);
}

TEST(GapSize, ScalesWithTheShapeAndIgnoresTheOrderOfFaces) {
  const Shape cube = cube_with_holes(1 / 8.0, 0);
  const double gap = gap_sizes(cube).widest;
  EXPECT_EQ(gap_sizes(test::flipped(cube)).widest, gap);
  EXPECT_NEAR(gap_sizes(test::permuted(cube, 1).shape).widest, gap, 1e-5 * gap);
  for (const double scale : {1e-30, 1e30}) {
    const Shape scaled = test::transformed(cube, scale, Eigen::Matrix3d::Identity(), {0, 0, 0});
    EXPECT_NEAR(gap_sizes(scaled).widest, scale * gap, 1e-5 * scale * gap);
  }
  const Shape turned = test::transformed(cube, 1, test::rotation(1), {0, 0, 0});
  EXPECT_NEAR(gap_sizes(turned).widest, gap, 2 * half_cell(turned));
}

TEST(GapSize, RejectsNonFinitePoints) {
  Shape cloud{Points::Random(20, 3), {}};
  cloud.vertices(3, 1) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(gap_sizes(cloud), InputError);
}

}  // namespace

}  // namespace shapegauge
