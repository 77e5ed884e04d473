// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/core/offset/block_cells.h"
#include "shapegauge/core/offset/cells_around.h"
#include "shapegauge/core/offset/exterior_grid.h"
#include "shapegauge/core/shape/shape.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// Returns for each cell whether it is exterior, according to the blocks.
std::vector<bool> exterior_cells(const ExteriorGrid& exterior) {
  const BlockGrid& grid = exterior.grid();
  std::vector<bool> cells;
  for (std::size_t index = 0; index < grid.block_count(); ++index) {
    for (int bit = 0; bit < cells_per_block; ++bit) cells.push_back((exterior.exterior_cells(index) >> bit & 1U) != 0);
  }
  return cells;
}

struct Flooded {
  explicit Flooded(const Shape& shape, double offset, double h, bool parallel = false)
      : grid(bounding_box(shape), offset, h),
        surface(grid, shape, 1, parallel),
        exterior(grid, surface, 0.9, parallel) {}

  [[nodiscard]] bool is_exterior(const Eigen::Vector3d& x) const {
    return cells_around(exterior, grid.to_cells(x)).touches_exterior;
  }

  BlockGrid grid;
  GridSurface surface;
  ExteriorGrid exterior;
};

TEST(ExteriorGrid, OfASphereContainsTheCellsBeyondTheOffsetDistance) {
  const double r = 0.2;
  const Flooded flooded(test::sphere(1, 4), r, 0.05);
  const std::vector<bool> cells = exterior_cells(flooded.exterior);
  std::size_t i = 0;
  for (std::size_t index = 0; index < flooded.grid.block_count(); ++index) {
    const Eigen::Vector3i block = flooded.grid.block_at(index);
    for (int bit = 0; bit < cells_per_block; ++bit, ++i) {
      const Eigen::Vector3d cell =
          (block_edge * block + Eigen::Vector3i(bit & 3, (bit >> 2) & 3, bit >> 4)).cast<double>().array() + 0.5;
      const double radius = (flooded.grid.origin + flooded.grid.cell * cell).norm();
      if (radius > 1 + 1.01 * r) {
        EXPECT_TRUE(cells[i]);
      } else if (radius < 1 + 0.97 * r) {
        EXPECT_FALSE(cells[i]);
      }
    }
  }
}

TEST(ExteriorGrid, StoresTheNearestTriangleOfCellsNearTheOffsetSurface) {
  const double r = 0.2;
  const Flooded flooded(test::sphere(1, 4), r, 0.05);
  const Points directions = test::sphere(1, 5).vertices;
  for (const auto& direction : directions.rowwise()) {
    const Eigen::Vector3d x = (1 + r) * direction.transpose();
    EXPECT_EQ(cells_around(flooded.exterior, flooded.grid.to_cells(x)).count, 8) << x.transpose();
  }
}

/// The box [-1, 1]^3 without one of its sides.
Shape open_box(Eigen::Index axis, double side) {
  Shape box = test::box({2, 2, 2}, 1);
  std::vector<Eigen::Index> remaining;
  for (Eigen::Index f = 0; f < box.triangles.rows(); ++f) {
    const Eigen::Vector3d along = box.vertices(box.triangles.row(f), axis);
    if ((along.array() != side).any()) remaining.push_back(f);
  }
  box.triangles = Triangles(box.triangles(remaining, Eigen::all));
  return box;
}

TEST(ExteriorGrid, FillsABoxOpenAtAnySideToItsBottom) {
  for (const double r : {0.2, 0.23, 0.26}) {
    for (int side = 0; side < 6; ++side) {
      const Shape box = open_box(side / 2, side % 2 == 0 ? -1 : 1);
      ASSERT_EQ(box.triangles.rows(), 10);
      const Flooded flooded(box, r, 0.05);
      const std::vector<bool> cells = exterior_cells(flooded.exterior);
      std::size_t i = 0;
      for (std::size_t index = 0; index < flooded.grid.block_count(); ++index) {
        const Eigen::Vector3i block = flooded.grid.block_at(index);
        for (int bit = 0; bit < cells_per_block; ++bit, ++i) {
          const Eigen::Vector3d cell =
              (block_edge * block + Eigen::Vector3i(bit & 3, (bit >> 2) & 3, bit >> 4)).cast<double>().array() + 0.5;
          const Eigen::Vector3d position = flooded.grid.origin + flooded.grid.cell * cell;
          if (position.cwiseAbs().maxCoeff() < 1 - 1.03 * r) {
            EXPECT_TRUE(cells[i]) << position.transpose();
          }
        }
      }
    }
  }
}

TEST(ExteriorGrid, ExcludesVoidsAndCavitiesWithANarrowMouth) {
  const Shape hollow = test::joined({test::sphere(1, 3), test::sphere(0.6, 3)});
  EXPECT_FALSE(Flooded(hollow, 0.1, 0.025).is_exterior({0, 0, 0}));
  EXPECT_TRUE(Flooded(test::torus(1, 0.4, 40, 20), 0.1, 0.025).is_exterior({0, 0, 0}));
  EXPECT_FALSE(Flooded(test::torus(1, 0.4, 40, 20), 0.65, 0.16).is_exterior({0, 0, 0}));
}

/// Returns true if a cell is exterior. Cells beyond the grid have the state of its border.
bool is_exterior_cell(const ExteriorGrid& exterior, const Eigen::Vector3i& cell) {
  const BlockGrid& grid = exterior.grid();
  const Eigen::Vector3i in_grid = cell.cwiseMin(block_edge * grid.blocks - Eigen::Vector3i::Ones());
  const Eigen::Vector3i in_block = in_grid - block_edge * (in_grid / block_edge);
  const int bit = in_block.x() + block_edge * (in_block.y() + block_edge * in_block.z());
  return (exterior.exterior_cells(grid.block_index(in_grid / block_edge)) >> bit & 1U) != 0;
}

TEST(ExteriorGrid, ListsTheCubesWithAnExteriorCorner) {
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
          touches |= is_exterior_cell(exterior, cell + Eigen::Vector3i(corner & 1, (corner >> 1) & 1, corner >> 2));
        }
        if (touches) expected |= BlockCells{1} << bit;
      }
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
