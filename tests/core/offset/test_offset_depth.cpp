// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <span>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/offset/cells_around.h"
#include "shapegauge/core/offset/mean_normals.h"
#include "shapegauge/core/offset/offset_depth.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/spatial/closest_point.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

constexpr double offset_of_depths = 0.1;

struct DepthGrid {
  explicit DepthGrid(const Shape& mesh)
      : shape(mesh),
        grid(bounding_box(mesh), offset_of_depths, offset_of_depths / 3),
        surface(grid, mesh, 0.75, false),
        exterior(grid, surface, 0.9, false) {}

  void solve(std::span<OffsetDepthTask> tasks) const {
    ClosestTriangles closest(grid, surface);
    find_offset_depths(exterior, closest, tasks);
  }
  [[nodiscard]] double distance_to_surface(const Eigen::Vector3d& x) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
      nearest = std::min(nearest, (closest_point(triangle_in_cells(grid, shape, f), x) - x).norm());
    }
    return nearest;
  }

  Shape shape;
  BlockGrid grid;
  GridSurface surface;
  ExteriorGrid exterior;
};

/// Points at distances of about r from the surface, on both sides.
std::vector<OffsetDepthTask> depth_tasks(const DepthGrid& of) {
  const Samples samples = sample_shape(of.shape, SampleSite::faces);
  RandomNumbers random(1);
  std::vector<OffsetDepthTask> tasks;
  for (Eigen::Index i = 0; i < samples.points.rows(); i += 2) {
    const double height = (random.uniform(0, 1) < 0.5 ? -1 : 1) * random.uniform(0.8, 1.1) * offset_of_depths;
    tasks.push_back(
        {.x = of.grid.to_cells(samples.points.row(i).transpose() + height * samples.normals.row(i).transpose())});
  }
  return tasks;
}

TEST(OffsetDepth, MatchesTheDistanceToTheSurface) {
  const DepthGrid of(test::torus(1, 0.4, 60, 40));
  std::vector<OffsetDepthTask> tasks = depth_tasks(of);
  of.solve(tasks);
  int small = 0;
  int exterior = 0;
  for (const OffsetDepthTask& task : tasks) {
    const double exact = 1 - of.distance_to_surface(task.x) / of.grid.r;
    const bool touches_exterior = cells_around(of.exterior, task.x).touches_exterior;
    if (std::abs(exact - 1e-3) > 1e-4) {
      EXPECT_EQ(task.is_exterior, touches_exterior && exact < 1e-3) << exact;
    }
    exterior += task.is_exterior ? 1 : 0;
    if (task.is_exterior || !touches_exterior) continue;
    EXPECT_NEAR(task.depth, exact, exact < blend_depth ? 1e-3 : 0.05);
    small += exact < blend_depth ? 1 : 0;
  }
  EXPECT_GT(exterior, 100);
  EXPECT_GT(small, 100);
}

TEST(OffsetDepth, IsOneWithoutATriangleNearby) {
  const DepthGrid of(test::sphere(1, 4));
  std::vector<OffsetDepthTask> tasks{{.x = of.grid.to_cells({0, 0, 0})}};
  of.solve(tasks);
  EXPECT_FALSE(tasks[0].is_exterior);
  EXPECT_EQ(tasks[0].depth, 1);
}

TEST(OffsetDepth, IsLargeInTheMiddleOfAWall) {
  const DepthGrid of(test::joined({test::sphere(1, 4), test::flipped(test::sphere(0.85, 4))}));
  std::vector<OffsetDepthTask> tasks{{.x = of.grid.to_cells({0.92, 0, 0})}};
  of.solve(tasks);
  EXPECT_FALSE(tasks[0].is_exterior);
  EXPECT_GT(tasks[0].depth, 0.3);
}

}  // namespace
}  // namespace shapegauge
