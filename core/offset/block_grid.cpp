// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/offset/block_grid.h"

#include <cmath>

namespace shapegauge {

BlockGrid::BlockGrid(const Eigen::AlignedBox3d& bounds, double offset, double h) : cell(h), r(offset / h) {
  // Points are searched up to two cells beyond r, by whole blocks.
  const double margin = block_edge * h * (std::ceil((r + 2) / block_edge) + 1);
  origin = bounds.min() - Eigen::Vector3d::Constant(margin);
  const Eigen::Vector3d extent = bounds.sizes() + Eigen::Vector3d::Constant(2 * margin);
  blocks = (extent / (block_edge * h)).array().ceil().cast<int>();
}

std::size_t BlockGrid::block_count() const {
  return static_cast<std::size_t>(blocks.x()) * static_cast<std::size_t>(blocks.y()) *
         static_cast<std::size_t>(blocks.z());
}

namespace {

/// Calls visit(i, j) for all pairs of adjacent blocks along an axis, in ascending order.
template <typename Visit>
void for_each_pair_along(const BlockGrid& grid, int axis, const Visit& visit) {
  const std::size_t stride = axis == 0 ? 1 : grid.block_index(Eigen::Vector3i::Unit(axis));
  const std::size_t span = stride * static_cast<std::size_t>(grid.blocks[axis]);
  const std::size_t count = grid.block_count();
  for (std::size_t start = 0; start < count; start += span) {
    for (std::size_t i = start; i + stride < start + span; ++i) visit(i, i + stride);
  }
}

}  // namespace

void dilate(const BlockGrid& grid, std::vector<std::uint8_t>& marked, int reach) {
  for (int step = 0; step < reach; ++step) {
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<std::uint8_t> wider = marked;
      for_each_pair_along(grid, axis, [&](std::size_t i, std::size_t j) {
        wider[j] |= marked[i];
        wider[i] |= marked[j];
      });
      marked.swap(wider);
    }
  }
}

void dilate_down(const BlockGrid& grid, std::vector<std::uint8_t>& marked) {
  for (int axis = 0; axis < 3; ++axis) {
    for_each_pair_along(grid, axis, [&](std::size_t i, std::size_t j) { marked[i] |= marked[j]; });
  }
}

}  // namespace shapegauge
