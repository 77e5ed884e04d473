// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/offset/sample_order.h"

#include <algorithm>
#include <cstdint>

#include "shapegauge/core/offset/grid_layout.h"

namespace shapegauge {

namespace {

/// Minimum number of samples of a batch, if there are as many.
constexpr std::size_t batch_size = 256;
constexpr unsigned sample_bits = 40;
static_assert(max_grid_blocks <= std::size_t{1} << (64 - sample_bits));

/// Returns the samples in the grid, sorted: block index in the high bits, sample index in the low ones.
std::vector<std::uint64_t> sorted_by_block(const BlockGrid& grid, const Points& points, const Points& normals) {
  const Eigen::Vector3d end = (block_edge * grid.blocks).cast<double>();
  std::vector<std::uint64_t> keys;
  keys.reserve(static_cast<std::size_t>(points.rows()));
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Vector3d p = grid.to_cells(points.row(i).transpose());
    const bool is_in_grid = p.allFinite() && (p.array() >= 0).all() && (p.array() < end.array()).all();
    if (!is_in_grid || !normals.row(i).allFinite()) continue;
    keys.push_back(std::uint64_t{grid.block_index(grid.block_of(p))} << sample_bits | static_cast<std::uint64_t>(i));
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

}  // namespace

SampleOrder::SampleOrder(const BlockGrid& grid, const Points& points, const Points& normals) {
  const std::vector<std::uint64_t> keys = sorted_by_block(grid, points, normals);
  samples.reserve(keys.size());
  for (std::size_t k = 0; k < keys.size(); ++k) {
    if (k == 0 || keys[k] >> sample_bits != keys[k - 1] >> sample_bits) groups.push_back({k, k});
    groups.back().end = k + 1;
    samples.push_back(static_cast<Eigen::Index>(keys[k] & ((std::uint64_t{1} << sample_bits) - 1)));
  }
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const bool is_full = !batches.empty() && groups[g].begin - groups[batches.back().begin].begin >= batch_size;
    if (batches.empty() || is_full) batches.push_back({g, g});
    batches.back().end = g + 1;
  }
}

}  // namespace shapegauge
