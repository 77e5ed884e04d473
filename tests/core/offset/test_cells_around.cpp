// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <gtest/gtest.h>
#include <random>
#include <set>

#include "shapegauge/core/offset/cells_around.h"
#include "shapegauge/core/shape/shape.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

struct Exterior {
  explicit Exterior(const Shape& shape, double offset, double h)
      : grid(bounding_box(shape), offset, h), surface(grid, shape, 1, false), exterior(grid, surface, 0.9, false) {}

  BlockGrid grid;
  GridSurface surface;
  ExteriorGrid exterior;
};

/// Reads the eight cells one by one.
struct LiteralCells {
  std::multiset<std::int32_t> triangles;
  bool touches_exterior = false;

  LiteralCells(const ExteriorGrid& exterior, const Eigen::Vector3d& x) {
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d step(corner & 1, (corner >> 1) & 1, corner >> 2);
      const Eigen::Vector3i cell = (x.array() - 0.5).floor().cast<int>() + step.array().cast<int>();
      const std::size_t block = exterior.grid().block_index(cell / block_edge);
      const Eigen::Vector3i in_block = cell - block_edge * (cell / block_edge);
      const int bit = in_block.x() + block_edge * (in_block.y() + block_edge * in_block.z());
      touches_exterior |= (exterior.exterior_cells(block) >> bit & 1U) != 0;
      if (exterior.block(block) < 0) continue;
      const auto index = static_cast<std::size_t>(exterior.block(block));
      const std::int32_t nearest = exterior.boundary()[index].nearest[static_cast<std::size_t>(bit)];
      triangles.insert(nearest < 0 ? ~nearest : nearest);
    }
  }
};

TEST(CellsAround, AreTheEightCellsAroundAPoint) {
  const Exterior torus(test::torus(1, 0.4, 40, 20), 0.1, 0.025);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> coordinate(0, 1);
  int partly = 0;
  for (int i = 0; i < 20'000; ++i) {
    Eigen::Vector3d x;
    // One cell from the border of the grid at least: there are eight cells around it.
    for (Eigen::Index k = 0; k < 3; ++k) x[k] = 1 + coordinate(random) * (block_edge * torus.grid.blocks[k] - 2.0);
    const CellsAround around = cells_around(torus.exterior, x);
    const LiteralCells expected(torus.exterior, x);
    ASSERT_EQ(around.touches_exterior, expected.touches_exterior);
    ASSERT_EQ(static_cast<std::size_t>(around.count), expected.triangles.size());
    const std::multiset<std::int32_t> found(around.triangles.begin(), around.triangles.begin() + around.count);
    ASSERT_EQ(found, expected.triangles);
    for (std::size_t k = found.size(); k < 8; ++k) {
      ASSERT_EQ(around.triangles[k], around.count > 0 ? around.triangles[0] : 0);
    }
    partly += around.count > 0 && around.count < 8 ? 1 : 0;
  }
  EXPECT_GT(partly, 100);
}

TEST(CellsAround, AreConnectedOnlyByPathsOutsideTheOffsetSolid) {
  const double r = 0.1;
  const Exterior wall(test::box({2, 2, 0.01}, 10), r, 0.025);
  const auto connected = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    return is_connected_to(wall.exterior, wall.grid.to_cells(from), wall.grid.to_cells(to));
  };
  const double above = 0.005 + r;
  EXPECT_TRUE(connected({0, 0, above}, {0.05, 0, above + 0.02}));
  EXPECT_TRUE(connected({0, 0, above + 0.01}, {0.08, 0.03, above + 0.01}));
  // Two cells inside the offset solid.
  EXPECT_FALSE(connected({0, 0, above - 0.05}, {0, 0, above + 0.01}));
  // Longer than the search goes.
  EXPECT_FALSE(connected({0, 0, above + 0.01}, {0.2, 0, above + 0.01}));
}

}  // namespace
}  // namespace shapegauge
