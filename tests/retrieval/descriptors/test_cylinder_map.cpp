// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "shapegauge/retrieval/descriptors/cylinder_map.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// Height and angle of the centre of a cell.
struct Cell {
  double height;
  double angle;
};

Cell cell_at(const CylinderFrame& frame, Eigen::Index row, Eigen::Index column) {
  return {((static_cast<double>(row) + 0.5) / frame.heights * 2 - 1) * frame.radius,
          (static_cast<double>(column) + 0.5) / frame.angles * 2 * std::numbers::pi};
}

/// Calls check(cell, distance, cosine) for each cell, distances in the units of the shape.
template <typename Check>
void for_each_cell(const Shape& shape, const CylinderFrame& frame, Check check) {
  const CylinderMap map = project_on_cylinder(shape, frame);
  ASSERT_EQ(map.distance.rows(), frame.heights);
  ASSERT_EQ(map.distance.cols(), frame.angles);
  for (Eigen::Index row = 0; row < frame.heights; ++row) {
    for (Eigen::Index column = 0; column < frame.angles; ++column) {
      SCOPED_TRACE(testing::Message() << "row " << row << ", column " << column);
      check(cell_at(frame, row, column), map.distance(row, column) * frame.radius, map.cosine(row, column));
    }
  }
}

TEST(CylinderMap, MatchesTheProfileOfASphere) {
  const CylinderFrame frame = {.axis = 2, .radius = 3, .angles = 64, .heights = 32};
  for_each_cell(test::sphere(2, 6), frame, [](const Cell& cell, double distance, double cosine) {
    const double square = 4 - cell.height * cell.height;
    EXPECT_NEAR(distance, std::sqrt(std::max(square, 0.0)), 0.003);
    EXPECT_NEAR(cosine, std::sqrt(std::max(square, 0.0)) / 2, 0.02);
  });
}

TEST(CylinderMap, OfABoxGivesTheDistanceToItsNearestSide) {
  const Eigen::Vector3d size(1, 2, 4);
  for (const int axis : {0, 1, 2}) {
    const CylinderFrame frame = {.axis = axis, .radius = 5, .angles = 100, .heights = 33};
    const double u = size[(axis + 1) % 3] / 2;
    const double v = size[(axis + 2) % 3] / 2;
    for_each_cell(test::box(size, 2), frame, [&](const Cell& cell, double distance, double cosine) {
      const bool within = std::abs(cell.height) < size[axis] / 2;
      const double to_u = u / std::abs(std::cos(cell.angle));
      const double to_v = v / std::abs(std::sin(cell.angle));
      EXPECT_NEAR(distance, within ? std::min(to_u, to_v) : 0, 1e-6);
      EXPECT_NEAR(cosine, within ? std::abs(to_u < to_v ? std::cos(cell.angle) : std::sin(cell.angle)) : 0, 1e-6);
    });
  }
}

TEST(CylinderMap, DistancesOfAnEllipsoidMatchItsCrossSections) {
  Shape ellipsoid = test::sphere(1, 6);
  ellipsoid.vertices.col(0) *= 2;
  ellipsoid.vertices.col(2) *= 3;
  const CylinderFrame frame = {.axis = 2, .radius = 4, .angles = 64, .heights = 64};
  for_each_cell(ellipsoid, frame, [](const Cell& cell, double distance, double /*cosine*/) {
    const double square = 1 - cell.height * cell.height / 9;
    const double slope = std::pow(std::cos(cell.angle) / 2, 2) + std::pow(std::sin(cell.angle), 2);
    EXPECT_NEAR(distance, square > 0 ? std::sqrt(square / slope) : 0, 0.02);
  });
}

TEST(CylinderMap, UsesTheOutermostSurfaceWithinTheCylinder) {
  const CylinderFrame frame = {.radius = 1.1, .angles = 64, .heights = 16};
  const CylinderMap outer = project_on_cylinder(test::sphere(1, 3), frame);
  const CylinderMap both = project_on_cylinder(test::joined({test::sphere(0.5, 3), test::sphere(1, 3)}), frame);
  EXPECT_EQ(both.distance, outer.distance);
  EXPECT_EQ(both.cosine, outer.cosine);
  EXPECT_EQ(project_on_cylinder(test::sphere(3, 3), frame).distance.maxCoeff(), 0);
}

TEST(CylinderMap, DoesNotDependOnTheOrientationAndOrderOfFaces) {
  const Shape shape = test::transformed(test::torus(1, 0.3, 24, 12), 1, test::rotation(1), {0.1, 0.2, 0.3});
  const CylinderFrame frame = {.radius = 2};
  const CylinderMap expected = project_on_cylinder(shape, frame);
  for (const Shape& same : {test::flipped(shape), test::soup(shape), test::permuted(shape, 3).shape}) {
    const CylinderMap found = project_on_cylinder(same, frame);
    EXPECT_LT((found.distance - expected.distance).cwiseAbs().maxCoeff(), 1e-6);
  }
}

}  // namespace
}  // namespace shapegauge
