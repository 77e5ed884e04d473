#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "shapegauge/core/offset/block_grid.h"

namespace shapegauge {

/// What is around a block's cells.
struct BlockDistances {
  /// Whether all centres are free and farther from the surface than the band, all covered, or neither.
  enum class Kind : std::uint8_t { free, covered, mixed } kind = Kind::free;
  std::uint64_t free_cells = ~std::uint64_t{0};         ///< whose centres are farther than r from the surface
  std::array<std::int32_t, cells_per_block> nearest{};  ///< triangle of each cell, where mixed
};

/// Which points are near; kept from block to block so as not to allocate anew.
struct NearbyPoints {
  std::vector<float> x, y, z, squared;
  std::vector<std::int32_t> triangle;
  std::vector<std::uint32_t> index;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> runs;
};

/// Distances of the centres of a block's cells to the surface's points, by all points within r + band of any.
BlockDistances block_distances(const BlockGrid& grid, const GridSurface& surface, const Eigen::Vector3i& block,
                               double band, NearbyPoints& nearby);

/// The smallest squared distance from x to the n points, and how far away each is.
float squared_distances(const float* x, const float* y, const float* z, std::size_t n, const Eigen::Vector3f& from,
                        float* squared);

/// The places of the numbers that do not exceed the limit, in their order; returns how many. There must be room for
/// sixteen more.
std::size_t indices_within(const float* numbers, std::size_t n, float limit, std::uint32_t* indices);

}  // namespace shapegauge
