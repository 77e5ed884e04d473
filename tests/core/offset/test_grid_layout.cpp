// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>

#include "shapegauge/core/offset/block_grid.h"
#include "shapegauge/core/offset/grid_layout.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// A sphere whose bounding box has a diagonal of 1.
Shape unit_sphere() { return test::sphere(0.5 / std::sqrt(3), 3); }

TEST(GridLayout, HasTheRequestedCellsPerOffsetWithinTheMemoryLimit) {
  const Shape shape = unit_sphere();
  const GridLayout layout = choose_grid_layout(shape, bounding_box(shape), 0.05, 4);
  EXPECT_EQ(layout.offset, 0.05);
  EXPECT_EQ(layout.cell, 0.0125);
  EXPECT_EQ(layout.spacing, 1);  // a quarter of r
}

TEST(GridLayout, EnlargesTheOffsetIfTheGridExceedsTheMemoryLimit) {
  const Shape shape = unit_sphere();
  const Eigen::AlignedBox3d bounds = bounding_box(shape);
  const GridLayout layout = choose_grid_layout(shape, bounds, 1e-5, 3);
  EXPECT_GT(layout.offset, 1e-5);
  EXPECT_GE(layout.offset, 2.5 * layout.cell * (1 - 1e-12));
  const BlockGrid grid(bounds, layout.offset, layout.cell);
  EXPECT_LE(grid.blocks.cast<double>().prod(), static_cast<double>(max_grid_blocks));
}

}  // namespace
}  // namespace shapegauge
