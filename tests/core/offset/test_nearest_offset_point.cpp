// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "shapegauge/core/offset/nearest_offset_point.h"
#include "shapegauge/core/shape/shape.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

constexpr double site_band = 0.9;
const Eigen::Vector3d nowhere = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());

struct TaskGrid {
  TaskGrid(const Shape& shape, double offset)
      : grid(bounding_box(shape), offset, offset / 3),
        surface(grid, shape, 0.75, false),
        exterior(grid, surface, site_band, false) {}

  void solve(std::vector<OffsetPointTask>& tasks) const {
    ClosestTriangles closest(grid, surface);
    find_nearest_offset_points(exterior, closest, tasks);
  }

  BlockGrid grid;
  GridSurface surface;
  ExteriorGrid exterior;
};

/// Edges of a cube of edge 1, once for each triangle at them, with two directions from their middles into the exterior.
struct CubeEdge {
  std::int32_t triangle;
  Eigen::Vector3d middle, towards, start;
};

std::vector<CubeEdge> edges_of(const Shape& cube) {
  const Eigen::Vector3d centre = bounding_box(cube).center();
  std::vector<CubeEdge> edges;
  for (Eigen::Index f = 0; f < cube.triangles.rows(); ++f) {
    const auto corner = [&](int k) -> Eigen::Vector3d { return cube.vertices.row(cube.triangles(f, k % 3)); };
    const Eigen::Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
    for (int k = 0; k < 3; ++k) {
      if ((corner(k + 1) - corner(k)).norm() > 1.1) continue;  // a diagonal
      const Eigen::Vector3d middle = (corner(k) + corner(k + 1)) / 2;
      const Eigen::Vector3d out = (middle - centre).normalized();
      const Eigen::Vector3d across = (normal - normal.dot(out) * out).normalized();
      const auto turned = [&](double angle) { return std::cos(angle) * out + std::sin(angle) * across; };
      edges.push_back({static_cast<std::int32_t>(f), middle, turned(-0.4), turned(0.3)});
    }
  }
  return edges;
}

TEST(NearestOffsetPoint, SearchConvergesAroundEdgesOfACube) {
  const Shape cube = test::box({1, 1, 1}, 1);
  const double r = 0.2;
  const TaskGrid grids(cube, r);
  std::vector<OffsetPointTask> tasks;
  const std::vector<CubeEdge> edges = edges_of(cube);
  ASSERT_EQ(edges.size(), 24U);
  for (const CubeEdge& edge : edges) {
    tasks.push_back({.p = grids.grid.to_cells(edge.middle + 0.2 * r * edge.towards),
                     .start = grids.grid.to_cells(edge.middle + r * edge.start),
                     .triangle = edge.triangle,
                     .known = nowhere,
                     .found = {}});
  }
  grids.solve(tasks);
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    ASSERT_TRUE(tasks[i].found) << i;
    const Eigen::Vector3d exact = grids.grid.to_cells(edges[i].middle + r * edges[i].towards);
    EXPECT_LT((*tasks[i].found - exact).norm(), 0.01 * grids.grid.r) << i;
  }
}

TEST(NearestOffsetPoint, SearchConvergesAroundCornersOfACube) {
  const Shape cube = test::box({1, 1, 1}, 1);
  const double r = 0.2;
  const TaskGrid grids(cube, r);
  const Eigen::Vector3d centre = bounding_box(cube).center();
  for (Eigen::Index f = 0; f < cube.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d corner = cube.vertices.row(cube.triangles(f, k));
      const Eigen::Vector3d out = 2 * (corner - centre);  // (+-1, +-1, +-1)
      const Eigen::Vector3d towards = out.cwiseProduct(Eigen::Vector3d(1, 2, 3)).normalized();
      const Eigen::Vector3d start = out.cwiseProduct(Eigen::Vector3d(2, 1, 2)).normalized();
      std::vector<OffsetPointTask> tasks{{.p = grids.grid.to_cells(corner + 0.3 * r * towards),
                                          .start = grids.grid.to_cells(corner + r * start),
                                          .triangle = static_cast<std::int32_t>(f),
                                          .known = nowhere,
                                          .found = {}}};
      grids.solve(tasks);
      ASSERT_TRUE(tasks[0].found) << f << ' ' << k;
      const Eigen::Vector3d exact = grids.grid.to_cells(corner + r * towards);
      EXPECT_LT((*tasks[0].found - exact).norm(), 0.01 * grids.grid.r) << f << ' ' << k;
    }
  }
}

TEST(NearestOffsetPoint, SearchStopsEarlyNearAKnownResult) {
  const Shape cube = test::box({1, 1, 1}, 1);
  const double r = 0.2;
  const TaskGrid grids(cube, r);
  const CubeEdge edge = edges_of(cube).front();
  const Eigen::Vector3d known = grids.grid.to_cells(edge.middle + r * edge.towards);
  std::vector<OffsetPointTask> tasks{{.p = grids.grid.to_cells(edge.middle + 0.2 * r * edge.towards),
                                      .start = grids.grid.to_cells(edge.middle + r * edge.start),
                                      .triangle = edge.triangle,
                                      .known = known,
                                      .found = {}}};
  grids.solve(tasks);
  EXPECT_FALSE(tasks[0].found);
}

}  // namespace
}  // namespace shapegauge
