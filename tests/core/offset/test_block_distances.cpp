// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/offset/block_distances.h"
#include "shapegauge/core/shape/shape.h"
#include "shapegauge/core/spatial/closest_point.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// Returns the distance from x to the nearest point, optionally of one triangle.
double distance_to_points(const GridPoints& points, const Eigen::Vector3d& x, std::int32_t triangle = -1) {
  double squared = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (triangle >= 0 && points.triangle[i] != triangle) continue;
    const Eigen::Vector3f point(points.x[i], points.y[i], points.z[i]);
    squared = std::min(squared, (point.cast<double>() - x).squaredNorm());
  }
  return std::sqrt(squared);
}

TEST(BlockDistances, ToTheSurfaceMatchExhaustiveSearch) {
  const Shape torus = test::torus(1, 0.4, 30, 20);
  const BlockGrid grid(bounding_box(torus), 0.2, 0.04);
  const double spacing = 1;
  const GridSurface surface(grid, torus, spacing, false);
  // Maximum excess of the distance to the points over the distance to the surface, at a distance of r.
  const double excess = spacing * spacing / (2 * grid.r);
  constexpr double band = 0.9;
  const BlockNeighbourhood around(grid.r + band);
  NearbyPoints nearby;
  std::array<int, 3> kinds{};
  for (std::size_t index = 0; index < grid.block_count(); ++index) {
    const Eigen::Vector3i block = grid.block_at(index);
    ASSERT_EQ(grid.block_index(block), index);
    BoundaryBlock found;
    const BlockKind kind = classify_block(grid, surface, static_cast<std::uint32_t>(index), around, nearby, found);
    if (kind == BlockKind::free) found.free = ~std::uint64_t{0};
    ++kinds[static_cast<std::size_t>(kind)];
    for (int bit = 0; bit < cells_per_block; bit += 9) {
      const Eigen::Vector3d centre =
          (block_edge * block + Eigen::Vector3i(bit & 3, (bit >> 2) & 3, bit >> 4)).cast<double>().array() + 0.5;
      double distance = std::numeric_limits<double>::infinity();
      for (Eigen::Index f = 0; f < torus.triangles.rows(); ++f) {
        const auto corner = [&](int k) { return grid.to_cells(torus.vertices.row(torus.triangles(f, k)).transpose()); };
        distance = std::min(distance, (closest_point({corner(0), corner(1), corner(2)}, centre) - centre).norm());
      }
      const bool is_free = (found.free >> bit & 1U) != 0;
      if (is_free) {
        EXPECT_GT(distance, grid.r - excess);
      } else {
        EXPECT_LE(distance, grid.r + 1e-3);
      }
      if (kind == BlockKind::free) {
        EXPECT_GT(distance, grid.r + band - excess);
      }
      if (kind == BlockKind::covered) {
        EXPECT_LT(distance, grid.r - std::sqrt(3.0) + 1e-3);
      }
      if (kind == BlockKind::mixed && distance < grid.r + band) {
        const std::array<std::int32_t, TriangleTable::batch_size> nearest{
            found.nearest[static_cast<std::size_t>(bit)], 0, 0, 0, 0, 0, 0, 0};
        TriangleTable::Vectors vectors;
        surface.triangles.vectors_to(centre, nearest.data(), vectors);
        EXPECT_NEAR(distance_to_points(surface.points, centre, nearest[0]), distance_to_points(surface.points, centre),
                    1e-4);
        // If the nearest point is not on the closest triangle, its triangle is hardly farther. Not needed near the
        // surface.
        if (distance > 0.9 * grid.r) {
          EXPECT_LE(std::sqrt(static_cast<double>(vectors.squared[0])), distance + excess);
        }
      }
    }
  }
  for (const int count : kinds) EXPECT_GT(count, 0);
}

TEST(IndicesWithin, SelectsIndicesOfNumbersUpToTheLimit) {
  RandomNumbers random(1, 0);
  for (std::size_t n = 0; n < 70; ++n) {
    std::vector<float> numbers(n + grid_padding);  // the padding is below the limit, and must not be found
    for (std::size_t i = 0; i < n; ++i) numbers[i] = static_cast<float>(random.uniform(0, 1));
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < n; ++i) {
      if (numbers[i] <= 0.4F) expected.push_back(i);
    }
    std::vector<std::uint32_t> found(n);
    found.resize(indices_within(numbers.data(), n, 0.4F, found.data()));
    EXPECT_EQ(found, expected) << n;
  }
}

}  // namespace
}  // namespace shapegauge
