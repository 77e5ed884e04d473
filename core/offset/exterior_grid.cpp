// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/offset/exterior_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/base/parallel_parts.h"
#include "shapegauge/core/offset/block_cells.h"
#include "shapegauge/core/offset/block_distances.h"
#include "shapegauge/core/offset/far_blocks.h"

namespace shapegauge {

namespace {

Eigen::Vector3i neighbour(const Eigen::Vector3i& block, int side) {
  Eigen::Vector3i result = block;
  result[side / 2] += side % 2 == 0 ? -1 : 1;
  return result;
}

constexpr std::int32_t unknown = -3;

}  // namespace

/// Flood-fills from the grid's border through the blocks that are not near the surface. Returns the blocks near the
/// surface that are adjacent to them.
std::vector<ExteriorGrid::Reached> ExteriorGrid::flood_far_blocks(const std::vector<std::uint8_t>& near_surface) {
  const FarBlocks far(grid_, near_surface);
  std::vector<Reached> touched;
  for (std::size_t row = 0; row < far.rows(); ++row) {
    for (std::size_t x = 0; x < far.size_x(); ++x) {
      const std::size_t i = row * far.size_x() + x;
      if (near_surface[i] == 0) {
        if (far.contain(row, x)) state_[i] = all_exterior;
        continue;
      }
      const BlockCells seeds = far.touching(row, x);
      if (seeds != 0) touched.push_back({static_cast<std::uint32_t>(i), seeds});
    }
  }
  return touched;
}

/// Classifies blocks. Appends one entry per block to boundary(), which is set for mixed blocks only.
std::vector<BlockKind> ExteriorGrid::classify(const std::vector<Reached>& blocks, double band, bool parallel) {
  const std::size_t first = boundary_.size();
  boundary_.resize(first + blocks.size());
  std::vector<BlockKind> kinds(blocks.size());
  const BlockNeighbourhood around(grid_.r + band);
  const auto classify_range = [&](const tbb::blocked_range<std::size_t>& range) {
    thread_local NearbyPoints nearby;
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      check_interruption();
      kinds[i] = classify_block(grid_, surface_, blocks[i].block, around, nearby, boundary_[first + i]);
    }
  };
  const tbb::blocked_range<std::size_t> all(0, blocks.size(), 8);
  if (parallel) {
    interruptible_parallel_for(all, classify_range);
  } else {
    classify_range(all);
  }
  return kinds;
}

/// Flood fill in rounds: blocks near the surface that were newly reached are classified in parallel, then the exterior
/// spreads until it reaches further ones. The result does not depend on the order.
class ExteriorGrid::Flood {
 public:
  Flood(ExteriorGrid& exterior, const std::vector<std::uint8_t>& near_surface)
      : exterior_(exterior), near_surface_(near_surface), reached_(exterior.flood_far_blocks(near_surface)) {
    for (std::size_t k = 0; k < reached_.size(); ++k) exterior_.state_[reached_[k].block] = state_of_reached(k);
  }

  void run(double band, bool parallel) {
    exterior_.boundary_.reserve(static_cast<std::size_t>(std::count(near_surface_.begin(), near_surface_.end(), 1)));
    while (!free_queue_.empty() || !reached_.empty()) {
      classify_reached(band, parallel);
      while (!free_queue_.empty() || !seeded_queue_.empty()) {
        check_();
        spread_one();
      }
    }
  }

 private:
  /// State of the k-th reached block until it is classified.
  static std::int32_t state_of_reached(std::size_t k) { return unknown - 1 - static_cast<std::int32_t>(k); }

  void classify_reached(double band, bool parallel) {
    const std::vector<Reached> blocks = std::move(reached_);
    reached_.clear();
    std::vector<BoundaryBlock>& boundary = exterior_.boundary_;
    const std::size_t first = boundary.size();
    std::size_t next = first;
    const std::vector<BlockKind> kinds = exterior_.classify(blocks, band, parallel);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      std::int32_t& state = exterior_.state_[blocks[i].block];
      if (kinds[i] == BlockKind::free) {
        state = all_exterior;
        free_queue_.push_back(blocks[i].block);
      } else if (kinds[i] == BlockKind::covered) {
        state = none_exterior;
      } else {
        if (next != first + i) boundary[next] = boundary[first + i];
        state = static_cast<std::int32_t>(next);
        exterior_.exterior_.push_back(0);
        seeds_.push_back(blocks[i].seeds & boundary[next].free);
        if (seeds_.back() != 0) seeded_queue_.push_back(state);
        ++next;
      }
    }
    boundary.resize(next);
  }

  void spread_one() {
    if (!free_queue_.empty()) {
      const std::uint32_t index = free_queue_.back();
      free_queue_.pop_back();
      return spread_to_neighbours(index, all_cells);
    }
    const auto boundary_index = static_cast<std::size_t>(seeded_queue_.back());
    seeded_queue_.pop_back();
    BlockCells& cells = exterior_.exterior_[boundary_index];
    const BlockCells wider = flood_fill(cells | seeds_[boundary_index], exterior_.boundary_[boundary_index].free);
    const BlockCells added = wider & ~cells;
    seeds_[boundary_index] = 0;
    cells = wider;
    spread_to_neighbours(exterior_.boundary_[boundary_index].index, added);
  }

  /// Spreads exterior cells of a block to its neighbours.
  void spread_to_neighbours(std::uint32_t index, BlockCells cells) {
    const BlockGrid& grid = exterior_.grid_;
    const Eigen::Vector3i block = grid.block_at(index);
    for (int side = 0; side < 6; ++side) {
      const BlockCells touched = cells_across(cells, side);
      const Eigen::Vector3i next = neighbour(block, side);
      if (touched == 0 || !grid.has_block(next)) continue;
      reach(static_cast<std::uint32_t>(grid.block_index(next)), touched);
    }
  }

  /// Seeds the cells of a block that touch exterior ones.
  void reach(std::uint32_t index, BlockCells touched) {
    std::int32_t& state = exterior_.state_[index];
    if (state == all_exterior || state == none_exterior) return;
    if (state >= 0) {
      const auto boundary_index = static_cast<std::size_t>(state);
      const BlockCells added =
          touched & exterior_.boundary_[boundary_index].free & ~exterior_.exterior_[boundary_index];
      if (added != 0 && seeds_[boundary_index] == 0) seeded_queue_.push_back(state);
      seeds_[boundary_index] |= added;
    } else if (state < unknown) {
      reached_[static_cast<std::size_t>(unknown - 1 - state)].seeds |= touched;
    } else if (near_surface_[index] == 0) {
      state = all_exterior;
      free_queue_.push_back(index);
    } else {
      state = state_of_reached(reached_.size());
      reached_.push_back({index, touched});
    }
  }

  ExteriorGrid& exterior_;
  const std::vector<std::uint8_t>& near_surface_;
  std::vector<Reached> reached_;
  std::vector<std::uint32_t> free_queue_;   ///< exterior blocks whose neighbours have not been visited
  std::vector<BlockCells> seeds_;           ///< by boundary block: cells that have not spread yet
  std::vector<std::int32_t> seeded_queue_;  ///< boundary blocks with seeds
  SparseInterruptionCheck check_;
};

namespace {

/// Returns the directions to the neighbours across edges and corners.
std::vector<Eigen::Vector3i> diagonals() {
  std::vector<Eigen::Vector3i> result;
  for (int i = 0; i < 27; ++i) {
    const Eigen::Vector3i direction(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (direction.squaredNorm() > 1) result.push_back(direction);
  }
  return result;
}

}  // namespace

/// The flood fill passes faces only. Blocks adjacent to exterior cells only across an edge or a corner have no exterior
/// cells, but points between them and those cells need their nearest triangles.
void ExteriorGrid::classify_diagonal_neighbours(const std::vector<std::uint8_t>& near_surface, double band,
                                                bool parallel) {
  std::vector<std::pair<Eigen::Vector3i, BlockCells>> directions;
  for (const Eigen::Vector3i& direction : diagonals()) directions.emplace_back(direction, cells_touching(direction));
  std::vector<Reached> reached;
  for (std::size_t i = 0; i < state_.size(); ++i) {
    const BlockCells exterior = near_surface[i] != 0 && state_[i] > unknown ? exterior_cells(i) : 0;
    if (exterior == 0) continue;
    const Eigen::Vector3i block = grid_.block_at(i);
    for (const auto& [direction, cells] : directions) {
      if ((exterior & cells) == 0 || !grid_.has_block(block + direction)) continue;
      const std::size_t next = grid_.block_index(block + direction);
      if (state_[next] != unknown || near_surface[next] == 0) continue;
      state_[next] = none_exterior;
      reached.push_back({static_cast<std::uint32_t>(next), 0});
    }
  }
  const std::size_t first = boundary_.size();
  const std::vector<BlockKind> kinds = classify(reached, band, parallel);
  std::size_t next = first;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    if (kinds[i] != BlockKind::mixed) continue;
    if (next != first + i) boundary_[next] = boundary_[first + i];
    state_[reached[i].block] = static_cast<std::int32_t>(next++);
  }
  boundary_.resize(next);
  exterior_.resize(next);
}

namespace {

/// Returns the cubes of a block (ExteriorGrid::Cubes), each as the bit of its lowest cell.
BlockCells cubes_at_exterior(const ExteriorGrid& exterior, const Eigen::Vector3i& block) {
  const BlockGrid& grid = exterior.grid();
  const auto cells = [&](int i, int j, int k) {
    const Eigen::Vector3i at = (block + Eigen::Vector3i(i, j, k)).cwiseMin(grid.blocks - Eigen::Vector3i::Ones());
    return exterior.exterior_cells(grid.block_index(at));
  };
  const auto along_x = [&](int j, int k) {
    const BlockCells first = cells(0, j, k);
    return first | (first & ~low_x_cells) >> 1U | (cells(1, j, k) & low_x_cells) << 3U;
  };
  const auto along_y = [&](int k) {
    const BlockCells first = along_x(0, k);
    return first | (first & ~low_y_cells) >> 4U | (along_x(1, k) & low_y_cells) << 12U;
  };
  const BlockCells first = along_y(0);
  return first | first >> 16U | along_y(1) << 48U;
}

}  // namespace

/// Sets the cubes of all blocks. Gives blocks without exterior cells, but with cubes, states of their own.
void ExteriorGrid::find_cubes(bool parallel) {
  const auto halves = [](BlockCells cubes) {
    return Cubes{static_cast<std::uint32_t>(cubes), static_cast<std::uint32_t>(cubes >> 32U)};
  };
  std::vector<std::uint8_t> is_near(state_.size());
  for (std::size_t i = 0; i < state_.size(); ++i) is_near[i] = exterior_cells(i) != 0 ? 1 : 0;
  dilate_down(grid_, is_near);
  std::vector<Cubes> of_others;
  for (std::size_t i = 0; i < state_.size(); ++i) {
    if (is_near[i] == 0 || state_[i] != none_exterior) continue;
    const BlockCells cubes = cubes_at_exterior(*this, grid_.block_at(i));
    if (cubes == 0) continue;
    of_others.push_back(halves(cubes));
    state_[i] = none_exterior - static_cast<std::int32_t>(of_others.size());
  }
  std::reverse(of_others.begin(), of_others.end());
  cubes_ = std::move(of_others);
  cubes_.push_back(halves(0));
  cubes_.push_back(halves(all_cells));
  first_cubes_ = static_cast<std::ptrdiff_t>(cubes_.size());
  cubes_.resize(cubes_.size() + boundary_.size());
  for_each_index(parallel, std::size_t{0}, boundary_.size(), [&](std::size_t i) {
    const Eigen::Vector3i block = grid_.block_at(boundary_[i].index);
    cubes_[static_cast<std::size_t>(first_cubes_) + i] = halves(cubes_at_exterior(*this, block));
  });
}

ExteriorGrid::ExteriorGrid(const BlockGrid& grid, const GridSurface& surface, double band, bool parallel)
    : grid_(grid), surface_(surface), state_(grid.block_count(), unknown) {
  std::vector<std::uint8_t> near_surface(grid.block_count());
  for (std::size_t i = 0; i < near_surface.size(); ++i)
    near_surface[i] = surface.points.first[i] != surface.points.first[i + 1] ? 1 : 0;
  dilate(grid, near_surface, static_cast<int>(std::ceil((grid.r + band) / block_edge)));
  Flood(*this, near_surface).run(band, parallel);
  classify_diagonal_neighbours(near_surface, band, parallel);
  std::replace(state_.begin(), state_.end(), unknown, none_exterior);
  find_cubes(parallel);
  for (std::size_t i = 0; i < boundary_.size(); ++i) {
    for (BlockCells cells = exterior_[i]; cells != 0; cells &= cells - 1) {
      std::int32_t& nearest = boundary_[i].nearest[static_cast<std::size_t>(std::countr_zero(cells))];
      nearest = ~nearest;
    }
  }
}

}  // namespace shapegauge
