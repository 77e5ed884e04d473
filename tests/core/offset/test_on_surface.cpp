// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shapegauge/core/offset/on_surface.h"
#include "shapegauge/core/shape/samples.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

using ::testing::ElementsAre;

TEST(OnSurfaceCheck, AcceptsSamplesAndRejectsPointsOffTheSurface) {
  const Shape torus = test::torus(1, 0.4, 30, 20);
  const BlockGrid grid(bounding_box(torus), 0.2, 0.05);
  const GridSurface surface(grid, torus, 1, false);
  const ExteriorGrid exterior(grid, surface, 0.9, false);
  const Samples samples = sample_shape(torus, SampleSite::faces);
  std::vector<std::uint32_t> nearby;
  for (Eigen::Index i = 0; i < samples.points.rows(); ++i) {
    const Eigen::Vector3d p = grid.to_cells(samples.points.row(i).transpose());
    const Eigen::Vector3d off_surface = p + 0.05 * grid.r * samples.normals.row(i).transpose();
    // With its own triangle, and with one elsewhere.
    for (const Eigen::Index triangle : {i, (i + 600) % samples.points.rows()}) {
      EXPECT_TRUE(is_on_surface(exterior, torus, p, static_cast<std::int32_t>(triangle), nearby)) << i;
      EXPECT_FALSE(is_on_surface(exterior, torus, off_surface, static_cast<std::int32_t>(triangle), nearby)) << i;
    }
  }
}

TEST(OnSurfaceCheck, AcceptsASampleOnASliverTriangle) {
  Shape shape = test::box({1, 1, 1}, 1);
  shape.vertices.conservativeResize(11, 3);
  shape.vertices.bottomRows(3) << 0, 0, 2, 0.35, 0, 2, 0.1, 1e-9, 2;
  shape.triangles.conservativeResize(13, 3);
  shape.triangles.row(12) << 8, 9, 10;
  const BlockGrid grid(bounding_box(shape), 0.05, 0.02);
  const GridSurface surface(grid, shape, 1, false);
  const ExteriorGrid exterior(grid, surface, 0.9, false);
  std::vector<std::uint32_t> nearby;
  const Eigen::Vector3d centroid = shape.vertices.bottomRows(3).colwise().mean().transpose();
  EXPECT_TRUE(is_on_surface(exterior, shape, grid.to_cells(centroid), 12, nearby));
}

TEST(LikelyTriangles, OfASampleAreItsFaceOrATriangleAtItsVertex) {
  const Shape shape{.vertices = Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 2, 0}},
                    .triangles = Triangles{{0, 1, 2}, {2, 1, 3}}};
  EXPECT_THAT(likely_triangles(shape, 2), ElementsAre(0, 1));
  EXPECT_THAT(likely_triangles(shape, 5), ElementsAre(0, 1, 1, 1, 0));
  EXPECT_THAT(likely_triangles(shape, 3), ElementsAre(0, 0, 0));
}

}  // namespace
}  // namespace shapegauge
