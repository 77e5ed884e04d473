#include "shapegauge/core/offset/exterior_grid.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <tbb/blocked_range.h>

#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/offset/block_distances.h"

namespace shapegauge {

namespace {

using Cells = std::uint64_t;
constexpr Cells all_cells = ~Cells{0};
constexpr Cells low_x = 0x1111111111111111;
constexpr Cells high_x = low_x << 3U;
constexpr Cells low_y = 0x000F000F000F000F;
constexpr Cells high_y = low_y << 12U;
constexpr Cells low_z = 0x000000000000FFFF;
constexpr Cells high_z = low_z << 48U;

/// Flood-fills the free cells of a block from some cells, across faces.
Cells fill(Cells cells, Cells free) {
  cells &= free;
  while (true) {
    Cells wider = cells | ((cells & ~high_x) << 1U) | ((cells & ~low_x) >> 1U) | ((cells & ~high_y) << 4U) |
                  ((cells & ~low_y) >> 4U) | (cells << 16U) | (cells >> 16U);
    wider &= free;
    if (wider == cells) return cells;
    cells = wider;
  }
}

/// Returns the cells of the neighbour on a side (0 to 5: -x, +x, -y, +y, -z, +z) that touch cells of a block.
Cells across(Cells cells, int side) {
  switch (side) {
    case 0:
      return (cells & low_x) << 3U;
    case 1:
      return (cells & high_x) >> 3U;
    case 2:
      return (cells & low_y) << 12U;
    case 3:
      return (cells & high_y) >> 12U;
    case 4:
      return (cells & low_z) << 48U;
    default:
      return (cells & high_z) >> 48U;
  }
}

Eigen::Vector3i neighbour(const Eigen::Vector3i& block, int side) {
  Eigen::Vector3i result = block;
  result[side / 2] += side % 2 == 0 ? -1 : 1;
  return result;
}

constexpr std::int32_t unknown = -3;

/// Rows of blocks along x as bits, which are flood-filled a row at a time.
class BlockRows {
 public:
  using Word = std::uint64_t;
  static constexpr int bits = 64;

  explicit BlockRows(const BlockGrid& grid)
      : words_((static_cast<std::size_t>(grid.blocks.x()) + bits - 1) / bits),
        rows_(words_ * static_cast<std::size_t>(grid.blocks.y()) * static_cast<std::size_t>(grid.blocks.z())) {}

  [[nodiscard]] std::size_t words() const { return words_; }
  [[nodiscard]] Word* row(std::size_t index) { return rows_.data() + index * words_; }
  [[nodiscard]] const Word* row(std::size_t index) const { return rows_.data() + index * words_; }

  void set(std::size_t row_index, std::size_t x) { row(row_index)[x / bits] |= Word{1} << (x % bits); }

 private:
  std::size_t words_;
  std::vector<Word> rows_;
};

/// Flood-fills the open bits of a word, in both directions.
BlockRows::Word spread(BlockRows::Word reached, BlockRows::Word open) {
  reached &= open;
  BlockRows::Word up = open;
  BlockRows::Word down = open;
  BlockRows::Word left = reached;
  BlockRows::Word right = reached;
  for (unsigned shift = 1; shift < BlockRows::bits; shift *= 2) {
    left |= up & (left << shift);
    up &= up << shift;
    right |= down & (right >> shift);
    down &= down >> shift;
  }
  return left | right;
}

/// Flood-fills the open bits of a row.
void spread_row(BlockRows::Word* reached, const BlockRows::Word* open, std::size_t words) {
  for (std::size_t i = 0; i < words; ++i) {
    if (i > 0) reached[i] |= reached[i - 1] >> (BlockRows::bits - 1);
    reached[i] = spread(reached[i], open[i]);
  }
  for (std::size_t i = words; i-- > 0;) {
    if (i + 1 < words) reached[i] |= reached[i + 1] << (BlockRows::bits - 1);
    reached[i] = spread(reached[i], open[i]);
  }
}

/// Blocks connected to the border of the grid through blocks that are not near the surface. A row of blocks has the
/// index y + z * (number of blocks along y).
class FarBlocks {
 public:
  FarBlocks(const BlockGrid& grid, const std::vector<std::uint8_t>& near_surface)
      : size_x_(static_cast<std::size_t>(grid.blocks.x())),
        size_y_(static_cast<std::size_t>(grid.blocks.y())),
        rows_(near_surface.size() / size_x_),
        open_(grid),
        far_(grid) {
    for (std::size_t row = 0; row < rows_; ++row) {
      for (std::size_t x = 0; x < size_x_; ++x) {
        if (near_surface[row * size_x_ + x] == 0) open_.set(row, x);
      }
    }
    flood();
  }

  [[nodiscard]] std::size_t size_x() const { return size_x_; }
  [[nodiscard]] std::size_t rows() const { return rows_; }

  [[nodiscard]] bool contain(std::size_t row, std::size_t x) const {
    return (far_.row(row)[x / BlockRows::bits] >> (x % BlockRows::bits) & 1U) != 0;
  }

  /// Returns the cells of a block that touch far blocks.
  [[nodiscard]] Cells touching(std::size_t row, std::size_t x) const {
    Cells cells = 0;
    if (x > 0 && contain(row, x - 1)) cells |= low_x;
    if (x + 1 < size_x_ && contain(row, x + 1)) cells |= high_x;
    for_each_side(row, [&](std::size_t next, Cells side) {
      if (contain(next, x)) cells |= side;
    });
    return cells;
  }

 private:
  /// Calls visit(row, cells) for each adjacent row, with the cells of a block of this row that touch it.
  template <typename Visit>
  void for_each_side(std::size_t row, const Visit& visit) const {
    const std::size_t y = row % size_y_;
    if (y > 0) visit(row - 1, low_y);
    if (y + 1 < size_y_) visit(row + 1, high_y);
    if (row >= size_y_) visit(row - size_y_, low_z);
    if (row + size_y_ < rows_) visit(row + size_y_, high_z);
  }

  /// Flood-fills from the first block, which is at the border.
  void flood() {
    std::vector<std::size_t> waiting{0};
    far_.set(0, 0);
    spread_row(far_.row(0), open_.row(0), open_.words());
    while (!waiting.empty()) {
      const std::size_t row = waiting.back();
      waiting.pop_back();
      for_each_side(row, [&](std::size_t next, Cells /*side*/) {
        if (spread_to_row(row, next)) waiting.push_back(next);
      });
    }
  }

  /// Spreads a row to an adjacent one. Returns true if that one changed.
  bool spread_to_row(std::size_t row, std::size_t next) {
    bool is_new = false;
    for (std::size_t i = 0; i < open_.words(); ++i) {
      const BlockRows::Word added = far_.row(row)[i] & open_.row(next)[i] & ~far_.row(next)[i];
      far_.row(next)[i] |= added;
      is_new |= added != 0;
    }
    if (is_new) spread_row(far_.row(next), open_.row(next), open_.words());
    return is_new;
  }

  std::size_t size_x_;
  std::size_t size_y_;
  std::size_t rows_;
  BlockRows open_;
  BlockRows far_;
};

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
      const Cells seeds = far.touching(row, x);
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
    parallel_for_parts(all, classify_range);
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
    const auto place = static_cast<std::size_t>(seeded_queue_.back());
    seeded_queue_.pop_back();
    Cells& cells = exterior_.exterior_[place];
    const Cells wider = fill(cells | seeds_[place], exterior_.boundary_[place].free);
    const Cells added = wider & ~cells;
    seeds_[place] = 0;
    cells = wider;
    spread_to_neighbours(exterior_.boundary_[place].index, added);
  }

  /// Spreads exterior cells of a block to its neighbours.
  void spread_to_neighbours(std::uint32_t index, Cells cells) {
    const BlockGrid& grid = exterior_.grid_;
    const Eigen::Vector3i block = grid.block_at(index);
    for (int side = 0; side < 6; ++side) {
      const Cells touched = across(cells, side);
      const Eigen::Vector3i next = neighbour(block, side);
      if (touched == 0 || !grid.has_block(next)) continue;
      reach(static_cast<std::uint32_t>(grid.block_index(next)), touched);
    }
  }

  /// Seeds the cells of a block that touch exterior ones.
  void reach(std::uint32_t index, Cells touched) {
    std::int32_t& state = exterior_.state_[index];
    if (state == all_exterior || state == none_exterior) return;
    if (state >= 0) {
      const auto place = static_cast<std::size_t>(state);
      const Cells added = touched & exterior_.boundary_[place].free & ~exterior_.exterior_[place];
      if (added != 0 && seeds_[place] == 0) seeded_queue_.push_back(state);
      seeds_[place] |= added;
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
  std::vector<Cells> seeds_;                ///< by boundary block: cells that have not spread yet
  std::vector<std::int32_t> seeded_queue_;  ///< boundary blocks with seeds
  SparseInterruptionCheck check_;
};

namespace {

/// Returns the cells of a block that touch its neighbour in a direction, whose coordinates are -1, 0 or 1.
Cells touching(const Eigen::Vector3i& direction) {
  constexpr std::array<Cells, 3> lowest{low_x, low_y, low_z};
  constexpr std::array<Cells, 3> highest{high_x, high_y, high_z};
  Cells cells = all_cells;
  for (std::size_t k = 0; k < 3; ++k) {
    const int part = direction[static_cast<Eigen::Index>(k)];
    if (part != 0) cells &= part < 0 ? lowest[k] : highest[k];
  }
  return cells;
}

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
  std::vector<std::pair<Eigen::Vector3i, Cells>> directions;
  for (const Eigen::Vector3i& direction : diagonals()) directions.emplace_back(direction, touching(direction));
  std::vector<Reached> reached;
  for (std::size_t i = 0; i < state_.size(); ++i) {
    const Cells exterior = near_surface[i] != 0 && state_[i] > unknown ? exterior_cells(i) : 0;
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

ExteriorGrid::ExteriorGrid(const BlockGrid& grid, const GridSurface& surface, double band, bool parallel)
    : grid_(grid), surface_(surface), state_(grid.block_count(), unknown) {
  std::vector<std::uint8_t> near_surface(grid.block_count());
  for (std::size_t i = 0; i < near_surface.size(); ++i)
    near_surface[i] = surface.points.first[i] != surface.points.first[i + 1];
  dilate(grid, near_surface, static_cast<int>(std::ceil((grid.r + band) / block_edge)));
  Flood(*this, near_surface).run(band, parallel);
  classify_diagonal_neighbours(near_surface, band, parallel);
  near_.resize(state_.size());
  for (std::size_t i = 0; i < state_.size(); ++i) {
    if (state_[i] == unknown) state_[i] = none_exterior;
    near_[i] = exterior_cells(i) != 0 ? 1 : 0;
  }
  dilate_down(grid, near_);
  for (std::size_t place = 0; place < boundary_.size(); ++place) {
    for (Cells cells = exterior_[place]; cells != 0; cells &= cells - 1) {
      std::int32_t& nearest = boundary_[place].nearest[static_cast<std::size_t>(std::countr_zero(cells))];
      nearest = ~nearest;
    }
  }
}

CellsAround cells_around(const ExteriorGrid& exterior, const Eigen::Vector3d& x) {
  const BlockGrid& grid = exterior.grid();
  std::array<std::array<std::size_t, 2>, 3> blocks;
  std::array<std::array<unsigned, 2>, 3> bits;
  std::size_t stride = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const int last = block_edge * grid.blocks[axis] - 1;
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
      const auto place = static_cast<std::size_t>(state);
      const unsigned bit = bits[0][i] | bits[1][j] | bits[2][k];
      const auto& nearest = exterior.boundary()[place].nearest;
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
