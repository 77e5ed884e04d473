// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/offset/offset_sites.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/offset/block_distances.h"

namespace shapegauge {

namespace {

/// Returns the centre of a cell of a block.
Eigen::Vector3d centre_of(const Eigen::Vector3i& block, int bit) {
  return (block_edge * block + Eigen::Vector3i(bit & 3, (bit >> 2) & 3, bit >> 4)).cast<double>().array() + 0.5;
}

/// Accumulates the sites of consecutive blocks.
struct FoundSites {
  std::vector<float> x, y, z;
  std::vector<std::int32_t> triangle;

  void clear() {
    for (std::vector<float>* values : {&x, &y, &z}) values->clear();
    triangle.clear();
  }

  void add(const ExteriorGrid& exterior, std::size_t number, double band) {
    const BoundaryBlock& block = exterior.boundary()[number];
    const double r = exterior.grid().r;
    // Most cells are farther; single precision suffices to reject them.
    const auto farthest2 = static_cast<float>(1.0001 * (r + band) * (r + band));
    const Eigen::Vector3i coordinates = exterior.grid().block_at(block.index);
    constexpr std::size_t batch = TriangleTable::batch_size;
    std::array<std::int32_t, batch> triangles{};
    std::array<Eigen::Vector3d, batch> centres;
    TriangleTable::Vectors vectors{};
    std::uint64_t remaining = exterior.boundary_cells(number);
    while (remaining != 0) {
      std::size_t count = 0;
      for (; remaining != 0 && count < batch; remaining &= remaining - 1, ++count) {
        const int bit = std::countr_zero(remaining);
        triangles[count] = ~block.nearest[static_cast<std::size_t>(bit)];  // of an exterior cell
        centres[count] = centre_of(coordinates, bit);
        vectors.set(count, centres[count]);
      }
      exterior.surface().triangles.vectors_to_each(vectors, triangles.data());
      for (std::size_t i = 0; i < count; ++i) {
        if (vectors.squared[i] > farthest2) continue;
        const double distance = std::sqrt(static_cast<double>(vectors.squared[i]));
        if (!(distance < r + band) || !(distance > 0)) continue;
        const Eigen::Vector3d site = centres[i] - (1 - r / distance) * vectors.vector(i);
        x.push_back(static_cast<float>(site.x()));
        y.push_back(static_cast<float>(site.y()));
        z.push_back(static_cast<float>(site.z()));
        triangle.push_back(triangles[i]);
      }
    }
  }
};

std::size_t cube_index(const OffsetSites& sites, const Eigen::Vector3i& cube) {
  return (static_cast<std::size_t>(cube.z()) * static_cast<std::size_t>(sites.cubes.y()) +
          static_cast<std::size_t>(cube.y())) *
             static_cast<std::size_t>(sites.cubes.x()) +
         static_cast<std::size_t>(cube.x());
}

/// Returns a box that contains the sites of a range of blocks, in cells.
Eigen::AlignedBox3d box_of(const OffsetSites& sites, const Eigen::Vector3i& low, const Eigen::Vector3i& high) {
  return {(block_edge * low).cast<double>().array() - sites.overhang,
          (block_edge * high).cast<double>().array() + sites.overhang};
}

/// Returns a copy with padding and no spare capacity.
std::vector<float> padded(const std::vector<float>& values) {
  std::vector<float> result;
  result.reserve(values.size() + grid_padding);
  result = values;
  result.resize(values.size() + grid_padding);
  return result;
}

}  // namespace

OffsetSites::OffsetSites(const ExteriorGrid& exterior, double band, bool parallel)
    : overhang(std::max(band - 0.5, 0.0)) {
  const std::vector<BoundaryBlock>& blocks = exterior.boundary();
  chunks.resize((blocks.size() + Chunk::blocks - 1) / Chunk::blocks);
  const auto fill = [&](std::size_t c) {
    thread_local FoundSites found;
    found.clear();
    Chunk& chunk = chunks[c];
    for (std::size_t i = 0; i < Chunk::blocks; ++i) {
      const std::size_t block = c * Chunk::blocks + i;
      if (block < blocks.size()) found.add(exterior, block, band);
      chunk.first[i + 1] = static_cast<std::uint16_t>(found.triangle.size());
    }
    chunk.x = padded(found.x);
    chunk.y = padded(found.y);
    chunk.z = padded(found.z);
    chunk.triangle = found.triangle;
  };
  for_each_index(parallel, std::size_t{0}, chunks.size(), fill);
  cubes = (exterior.grid().blocks.array() + cube_edge - 1) / cube_edge;
  occupied.resize(static_cast<std::size_t>(cubes.cast<long>().prod()));
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Eigen::Vector3i cube = exterior.grid().block_at(blocks[i].index) / cube_edge;
    std::uint8_t& is_occupied = occupied[cube_index(*this, cube)];
    const BlockSites sites = sites_of_block(i);
    if (sites.begin == sites.end || is_occupied != 0) continue;
    is_occupied = 1;
    occupied_cubes.push_back(cube);
  }
}

double NearbySites::distance_to_nearest(const Eigen::Vector3d& x) {
  constexpr int edge = OffsetSites::cube_edge;
  queue_.clear();
  double upper_bound2 = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < sites_.occupied_cubes.size(); ++i) {
    const Eigen::Vector3i begin = edge * sites_.occupied_cubes[i];
    const Eigen::AlignedBox3d box = box_of(sites_, begin, begin.array() + edge);
    const Eigen::Vector3d& low = box.min();
    const Eigen::Vector3d& high = box.max();
    const double nearest2 = (low - x).cwiseMax(x - high).cwiseMax(0).squaredNorm();
    if (nearest2 > upper_bound2) continue;
    upper_bound2 = std::min(upper_bound2, (x - low).cwiseAbs().cwiseMax((high - x).cwiseAbs()).squaredNorm());
    queue_.emplace_back(nearest2, static_cast<std::uint32_t>(i));
  }
  std::sort(queue_.begin(), queue_.end());
  double best2 = std::numeric_limits<double>::infinity();
  for (const auto& [nearest2, cube] : queue_) {
    if (nearest2 >= best2) break;
    best2 = std::min(best2, nearest_in_cube(sites_.occupied_cubes[cube], x, best2));
  }
  return std::sqrt(best2);
}

/// Returns the smaller of the limit and the squared distance to the nearest site of the cube.
double NearbySites::nearest_in_cube(const Eigen::Vector3i& cube, const Eigen::Vector3d& x, double limit) {
  constexpr int edge = OffsetSites::cube_edge;
  const BlockGrid& grid = exterior_.grid();
  const Eigen::Vector3i begin = edge * cube;
  const Eigen::Vector3i end = (begin.array() + edge).matrix().cwiseMin(grid.blocks);
  const Eigen::Vector3f from = x.cast<float>();
  for (int k = begin.z(); k < end.z(); ++k) {
    for (int j = begin.y(); j < end.y(); ++j) {
      if (box_of(sites_, {begin.x(), j, k}, {end.x(), j + 1, k + 1}).squaredExteriorDistance(x) >= limit) continue;
      const std::size_t row = grid.block_index({0, j, k});
      for (int i = begin.x(); i < end.x(); ++i) {
        const std::int32_t state = exterior_.block(row + static_cast<std::size_t>(i));
        if (state < 0) continue;
        const auto& [chunk, first, last, first_site_number] = sites_.sites_of_block(static_cast<std::size_t>(state));
        if (first == last) continue;
        if (squared_scratch_.size() < last - first + grid_padding) squared_scratch_.resize(last - first + grid_padding);
        limit = std::min(limit, static_cast<double>(squared_distances(&chunk.x[first], &chunk.y[first], &chunk.z[first],
                                                                      last - first, from, squared_scratch_.data())));
      }
    }
  }
  return limit;
}

void NearbySites::collect(const Eigen::AlignedBox3d& box, double reach) {
  constexpr int edge = OffsetSites::cube_edge;
  x_.clear();
  y_.clear();
  z_.clear();
  site_.clear();
  const BlockGrid& grid = exterior_.grid();
  const Eigen::Vector3i one = Eigen::Vector3i::Ones();
  const double farthest = reach + sites_.overhang;
  const Eigen::Vector3i low = grid.block_of(box.min().array() - farthest).cwiseMax(0);
  const Eigen::Vector3i high = grid.block_of(box.max().array() + farthest).cwiseMin(grid.blocks - one);
  const double reach2 = reach * reach;
  Eigen::Vector3i cube;
  for (cube.z() = low.z() / edge; cube.z() <= high.z() / edge; ++cube.z()) {
    for (cube.y() = low.y() / edge; cube.y() <= high.y() / edge; ++cube.y()) {
      for (cube.x() = low.x() / edge; cube.x() <= high.x() / edge; ++cube.x()) {
        if (sites_.occupied[cube_index(sites_, cube)] == 0) continue;
        const Eigen::Vector3i begin = (edge * cube).cwiseMax(low);
        const Eigen::Vector3i end = (edge * (cube + one)).cwiseMin(high + one);
        if (box_of(sites_, begin, end).squaredExteriorDistance(box) > reach2) continue;
        collect_blocks(begin, end, box, reach2);
      }
    }
  }
  for (std::vector<float>* values : {&x_, &y_, &z_, squared_.data(), squared_.data() + 1})
    values->resize(site_.size() + grid_padding);
}

/// Collects the sites of the blocks from begin to before end whose row along x is near the box.
void NearbySites::collect_blocks(const Eigen::Vector3i& begin, const Eigen::Vector3i& end,
                                 const Eigen::AlignedBox3d& box, double squared_reach) {
  for (int k = begin.z(); k < end.z(); ++k) {
    for (int j = begin.y(); j < end.y(); ++j) {
      const Eigen::Vector3i first(begin.x(), j, k);
      if (box_of(sites_, first, {end.x(), j + 1, k + 1}).squaredExteriorDistance(box) > squared_reach) continue;
      collect_row(first, end.x());
    }
  }
}

/// Collects the sites of a row of blocks along x.
void NearbySites::collect_row(const Eigen::Vector3i& begin, int end) {
  const std::size_t index = exterior_.grid().block_index(begin);
  for (int i = 0; i < end - begin.x(); ++i) {
    const std::int32_t state = exterior_.block(index + static_cast<std::size_t>(i));
    if (state < 0) continue;
    const auto& [chunk, first, last, first_site_number] = sites_.sites_of_block(static_cast<std::size_t>(state));
    x_.insert(x_.end(), &chunk.x[first], &chunk.x[last]);
    y_.insert(y_.end(), &chunk.y[first], &chunk.y[last]);
    z_.insert(z_.end(), &chunk.z[first], &chunk.z[last]);
    for (std::size_t k = first; k < last; ++k) site_.push_back(first_site_number + static_cast<std::uint32_t>(k));
  }
}

std::array<double, 2> NearbySites::measure(const std::array<Eigen::Vector3d, 2>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    nearest_[i] = std::sqrt(static_cast<double>(
        squared_distances(x_.data(), y_.data(), z_.data(), site_.size(), points[i].cast<float>(), squared_[i].data())));
  }
  return nearest_;
}

void NearbySites::find_start_sites(std::size_t point, double margin, double min_spacing, std::size_t max_count,
                                   std::vector<Site>& found) {
  found.clear();
  const auto limit = static_cast<float>(std::pow(nearest_[point] + margin, 2));
  const std::vector<float>& squared = squared_[point];
  within_margin_.clear();
  candidates_.resize(site_.size());
  const std::size_t count = indices_within(squared.data(), site_.size(), limit, candidates_.data());
  for (std::size_t i = 0; i < count; ++i) within_margin_.push_back({candidates_[i], squared[candidates_[i]]});
  while (found.size() < max_count && !within_margin_.empty()) {
    const auto best = std::min_element(within_margin_.begin(), within_margin_.end(),
                                       [](const Site& a, const Site& b) { return a.distance < b.distance; });
    const std::size_t chosen = best->site;
    found.push_back({site_[chosen], std::sqrt(best->distance)});
    const auto min_spacing2 = static_cast<float>(min_spacing * min_spacing);
    std::erase_if(within_margin_, [&](const Site& site) {
      const float dx = x_[site.site] - x_[chosen];
      const float dy = y_[site.site] - y_[chosen];
      const float dz = z_[site.site] - z_[chosen];
      return dx * dx + dy * dy + dz * dz <= min_spacing2;
    });
  }
}

}  // namespace shapegauge
