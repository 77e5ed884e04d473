// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/offset/grid_surface.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

Eigen::Vector3d point_at(const GridPoints& points, std::size_t i) {
  return Eigen::Vector3f(points.x[i], points.y[i], points.z[i]).cast<double>();
}

TEST(GridSurface, SamplesTrianglesAtTheRequestedSpacing) {
  const Shape torus = test::torus(1, 0.4, 12, 9);
  const BlockGrid grid(bounding_box(torus), 0.3, 0.1);
  const double spacing = 0.75;
  const GridSurface surface(grid, torus, spacing, false);
  EXPECT_EQ(surface.omitted.size(), 0U);
  RandomNumbers random(1, 0);
  for (Eigen::Index f = 0; f < torus.triangles.rows(); f += 5) {
    const auto corner = [&](int k) { return grid.to_cells(torus.vertices.row(torus.triangles(f, k)).transpose()); };
    const double u = random.uniform(0, 1);
    const double v = random.uniform(0, 1 - u);
    const Eigen::Vector3d position = corner(0) + u * (corner(1) - corner(0)) + v * (corner(2) - corner(0));
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
      if (surface.points.triangle[i] == f) nearest = std::min(nearest, (point_at(surface.points, i) - position).norm());
    }
    EXPECT_LE(nearest, spacing) << f;
  }
}

TEST(GridSurface, KeepsOneSmallTrianglePerCube) {
  const Shape sphere = test::sphere(1, 6);
  const double r = 0.4;
  const BlockGrid grid(bounding_box(sphere), r, r / 3);
  const GridSurface surface(grid, sphere, 0.75, false);
  const auto all = static_cast<std::size_t>(sphere.triangles.rows());
  EXPECT_LT(surface.points.size(), all / 2);
  std::vector<int> seen(all, 0);
  for (const GridPoints* points : {&surface.points, &surface.omitted}) {
    for (std::size_t i = 0; i < points->size(); ++i) ++seen[static_cast<std::size_t>(points->triangle[i])];
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), sphere.triangles.rows());
  double area = 0;
  for (std::size_t i = 0; i < surface.points.size(); ++i) area += static_cast<double>(surface.points.area[i]);
  EXPECT_NEAR(area, SurfaceExtent(sphere).area / (grid.cell * grid.cell), 1e-3 * area);
  // The centres of two triangles in the same cube are at most its diagonal apart.
  for (std::size_t i = 0; i < surface.omitted.size(); i += 211) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < surface.points.size(); ++k) {
      nearest = std::min(nearest, (point_at(surface.points, k) - point_at(surface.omitted, i)).norm());
    }
    EXPECT_LE(nearest, std::sqrt(3.0) * grid.r / 16) << i;
  }
}

TEST(GridSurface, SearchReturnsAllPointsWithinReachOfAPosition) {
  const Shape torus = test::torus(1, 0.4, 30, 20);
  const BlockGrid grid(bounding_box(torus), 0.2, 0.05);
  const GridSurface surface(grid, torus, 1, false);
  RandomNumbers random(2, 0);
  std::vector<GridPoints::Run> runs;
  for (int round = 0; round < 200; ++round) {
    const Eigen::Vector3d position{random.uniform(0, block_edge * grid.blocks.x()),
                                   random.uniform(0, block_edge * grid.blocks.y()),
                                   random.uniform(0, block_edge * grid.blocks.z())};
    const double reach = random.uniform(0.1, 9);
    surface.points.find_runs(grid, position, reach, runs);
    std::vector<int> found(surface.points.size(), 0);
    for (const auto& [begin, end] : runs) {
      for (std::uint32_t i = begin; i < end; ++i) ++found[i];
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
      const double far = (point_at(surface.points, i) - position).cwiseAbs().maxCoeff();
      if (far < reach - 1e-3) {
        ASSERT_EQ(found[i], 1);
      }
      if (far > reach + block_edge + 1e-3) {
        ASSERT_EQ(found[i], 0);
      }
    }
  }
}

TEST(GridSurface, GroupsOfPointsHaveSmallTightBoxes) {
  const Shape torus = test::torus(1, 0.4, 150, 100);
  const BlockGrid grid(bounding_box(torus), 0.2, 0.2 / 3);
  const GridSurface surface(grid, torus, 0.75, false);
  const GridPoints& points = surface.points;
  const std::size_t groups = (points.size() + PointBoxes::group_size - 1) / PointBoxes::group_size;
  double sizes = 0;
  for (std::size_t group = 0; group < groups; ++group) {
    Eigen::AlignedBox3d box;
    for (std::size_t i = 0; i < PointBoxes::group_size; ++i) {
      const std::size_t point = group * PointBoxes::group_size + i;
      if (point < points.size()) box.extend(point_at(points, point));
    }
    for (Eigen::Index k = 0; k < 3; ++k) {
      EXPECT_EQ(points.boxes.low[static_cast<std::size_t>(k)][group], static_cast<float>(box.min()[k]));
      EXPECT_EQ(points.boxes.high[static_cast<std::size_t>(k)][group], static_cast<float>(box.max()[k]));
    }
    sizes += box.diagonal().norm();
  }
  EXPECT_LT(sizes / static_cast<double>(groups), 0.75 * block_edge);
}

}  // namespace
}  // namespace shapegauge
