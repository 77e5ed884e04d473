// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/offset/cells_around.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace shapegauge {

CellsAround cells_around(const ExteriorGrid& exterior, const Eigen::Vector3d& x) {
  const BlockGrid& grid = exterior.grid();
  std::array<std::array<std::size_t, 2>, 3> blocks;
  std::array<std::array<unsigned, 2>, 3> bits;
  std::size_t stride = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const int last = block_edge * grid.blocks[axis] - 1;
    // NOLINTNEXTLINE(bugprone-incorrect-roundings): half a cell is part of the formula; negative positions are clamped
    const auto low = static_cast<unsigned>(std::clamp(static_cast<int>(x[axis] + 0.5) - 1, 0, last - 1));
    blocks[k] = {(low >> 2U) * stride, ((low + 1) >> 2U) * stride};
    bits[k] = {(low & 3U) << (2 * k), ((low + 1) & 3U) << (2 * k)};
    stride *= static_cast<std::size_t>(grid.blocks[axis]);
  }
  CellsAround result;
  bool touches = false;
  std::size_t count = 0;
  // The two cells along x are usually in the same block, as adjacent bits.
  const std::size_t blocks_along_x = blocks[0][0] == blocks[0][1] ? 1 : 2;
  const auto add = [&](std::int32_t nearest) {
    touches |= nearest < 0;
    result.triangles[count++] = nearest < 0 ? ~nearest : nearest;
  };
  for (std::size_t row = 0; row < 4; ++row) {
    const std::size_t j = row & 1U;
    const std::size_t k = row >> 1U;
    for (std::size_t i = 0; i < blocks_along_x; ++i) {
      const std::int32_t state = exterior.block(blocks[0][i] + blocks[1][j] + blocks[2][k]);
      if (state < 0) {
        touches |= state == ExteriorGrid::all_exterior;
        continue;
      }
      const auto boundary_index = static_cast<std::size_t>(state);
      const unsigned bit = bits[0][i] | bits[1][j] | bits[2][k];
      const auto& nearest = exterior.boundary()[boundary_index].nearest;
      add(nearest[bit]);
      if (blocks_along_x == 1) add(nearest[bit + 1]);
    }
  }
  result.count = static_cast<int>(count);
  result.touches_exterior = touches;
  if (count < 8)
    std::fill(result.triangles.begin() + static_cast<std::ptrdiff_t>(count), result.triangles.end(),
              result.triangles[0]);
  return result;
}

namespace {

/// Returns true if the known triangles around x are at least this far away.
bool is_free(const ExteriorGrid& exterior, const CellsAround& around, const Eigen::Vector3d& x, double least) {
  TriangleTable::Vectors vectors;
  if (!vectors_around(exterior, around, x, vectors)) return around.touches_exterior;
  return *std::min_element(vectors.squared.begin(), vectors.squared.end()) >= static_cast<float>(least * least);
}

}  // namespace

bool is_connected_to(const ExteriorGrid& exterior, const Eigen::Vector3d& x, const Eigen::Vector3d& to) {
  constexpr double max_length = 5;
  constexpr double spacing = 0.7;
  const double length = (to - x).norm();
  if (length > max_length) return false;
  const int steps = static_cast<int>(std::ceil(length / spacing));
  const double r = exterior.grid().r;
  for (int i = 1; i < steps; ++i) {
    const Eigen::Vector3d between = x + static_cast<double>(i) / steps * (to - x);
    const CellsAround around = cells_around(exterior, between);
    if (!is_free(exterior, around, between, r - length * length / (4 * r))) return false;
    if (around.touches_exterior) return true;
  }
  return true;
}

}  // namespace shapegauge
