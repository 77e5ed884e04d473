#include <gtest/gtest.h>

#include "shapegauge/core/offset/exterior_cubes.h"
#include "shapegauge/core/shape/shape.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// Returns true if a cell is exterior. Cells beyond the grid have the state of its border.
bool is_exterior(const ExteriorGrid& exterior, const Eigen::Vector3i& cell) {
  const BlockGrid& grid = exterior.grid();
  const Eigen::Vector3i in_grid = cell.cwiseMin(block_edge * grid.blocks - Eigen::Vector3i::Ones());
  const Eigen::Vector3i in_block = in_grid - block_edge * (in_grid / block_edge);
  const int bit = in_block.x() + block_edge * (in_block.y() + block_edge * in_block.z());
  return (exterior.exterior_cells(grid.block_index(in_grid / block_edge)) >> bit & 1U) != 0;
}

TEST(ExteriorCubes, AreThoseWithAnExteriorCorner) {
  const double r = 0.1;
  const Shape torus = test::torus(1, 0.4, 40, 20);
  const BlockGrid grid(bounding_box(torus), r, r / 3);
  const GridSurface surface(grid, torus, 1, false);
  for (const bool parallel : {false, true}) {
    const ExteriorGrid exterior(grid, surface, 0.9, parallel);
    int without_exterior_cells = 0;
    for (std::size_t index = 0; index < grid.block_count(); ++index) {
      const Eigen::Vector3i block = grid.block_at(index);
      BlockCells expected = 0;
      for (int bit = 0; bit < cells_per_block; ++bit) {
        const Eigen::Vector3i cell = block_edge * block + Eigen::Vector3i(bit & 3, (bit >> 2) & 3, bit >> 4);
        bool touches = false;
        for (int corner = 0; corner < 8; ++corner) {
          touches |= is_exterior(exterior, cell + Eigen::Vector3i(corner & 1, (corner >> 1) & 1, corner >> 2));
        }
        if (touches) expected |= BlockCells{1} << bit;
      }
      ASSERT_EQ(cubes_at_exterior(exterior, block), expected) << index;
      const std::int32_t state = exterior.block(index);
      const ExteriorGrid::Cubes& stored = exterior.cubes()[state];
      ASSERT_EQ(stored[0] | BlockCells{stored[1]} << 32U, expected) << index;
      EXPECT_EQ(state == ExteriorGrid::none_exterior, expected == 0 && state < 0) << index;
      without_exterior_cells += expected != 0 && exterior.exterior_cells(index) == 0 ? 1 : 0;
    }
    EXPECT_GT(without_exterior_cells, 10);
  }
}

}  // namespace
}  // namespace shapegauge
