// SPDX-License-Identifier: GPL-3.0-or-later
// Loops over points, compiled for each instruction set supported by Highway.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shapegauge/core/offset/block_distances.cpp"
#include "shapegauge/core/offset/block_distances.h"

#include <algorithm>
#include <cmath>
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>
#include <limits>
#include <vector>

#include "shapegauge/core/offset/point_groups-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {
namespace {

float squared_distances_to(const float* x, const float* y, const float* z, std::size_t n, const Eigen::Vector3f& from,
                           float* squared) {
  const PointLanes d;
  const auto infinite = hn::Set(d, std::numeric_limits<float>::infinity());
  const QueryPoint query(from);
  auto smallest = infinite;
  for (std::size_t i = 0; i < n; i += hn::Lanes(d)) {
    const auto sum = query.squared(x + i, y + i, z + i);
    hn::StoreU(sum, d, squared + i);
    smallest = hn::Min(smallest, hn::IfThenElse(hn::FirstN(d, n - i), sum, infinite));
  }
  return hn::GetLane(hn::MinOfLanes(d, smallest));
}

std::size_t indices_up_to(const float* numbers, std::size_t n, float limit, std::uint32_t* indices) {
  const PointLanes d;
  const Numbers most = hn::Set(d, limit);
  std::size_t count = 0;
  for (std::size_t i = 0; i < n; i += hn::Lanes(d)) {
    const auto is_within = hn::And(hn::FirstN(d, n - i), hn::Le(hn::LoadU(d, numbers + i), most));
    if (hn::AllFalse(d, is_within)) continue;
    for_each_lane_of(is_within, [&](std::size_t lane) { indices[count++] = static_cast<std::uint32_t>(i + lane); });
  }
  return count;
}

/// Computes the squared distances of the points of the runs from a block's centre, and the nearest point.
void measure_from_centre(const GridPoints& points, const Eigen::Vector3f& centre, NearbyPoints& nearby) {
  nearby.nearest_squared = std::numeric_limits<float>::infinity();
  float* squared = nearby.squared.data();
  const GridPoints::Run* nearest_run = nullptr;
  const float* squared_of_nearest_run = nullptr;
  for (const GridPoints::Run& run : nearby.runs) {
    const std::size_t count = run.end - run.begin;
    const float smallest =
        squared_distances_to(&points.x[run.begin], &points.y[run.begin], &points.z[run.begin], count, centre, squared);
    if (smallest < nearby.nearest_squared) {
      nearby.nearest_squared = smallest;
      nearest_run = &run;
      squared_of_nearest_run = squared;
    }
    squared += count;
  }
  if (nearest_run == nullptr) return;
  const float* end = squared_of_nearest_run + (nearest_run->end - nearest_run->begin);
  const float* found = std::find(squared_of_nearest_run, end, nearby.nearest_squared);
  nearby.nearest = nearest_run->begin + static_cast<std::size_t>(found - squared_of_nearest_run);
}

/// Copies the points of the runs that may be the nearest to the centre of one of a block's cells. With c the block's
/// centre and a the point nearest to it, a cell's centre c + e is no farther from p than from a if
/// |c - p|^2 - |c - a|^2 <= 2 e (p - a), and no coordinate of e exceeds 3 / 2.
void keep_candidates(const GridPoints& points, NearbyPoints& nearby) {
  const PointLanes d;
  constexpr float rounding = 1e-3F;  // of squared distances up to a hundred or two
  const QueryPoint a({points.x[nearby.nearest], points.y[nearby.nearest], points.z[nearby.nearest]});
  const Numbers least = hn::Set(d, nearby.nearest_squared + rounding);
  const Numbers edge = hn::Set(d, static_cast<float>(block_edge - 1));
  const float* squared = nearby.squared.data();
  std::size_t count = 0;
  for (const auto& [begin, end] : nearby.runs) {
    for (std::size_t i = begin; i < end; i += hn::Lanes(d)) {
      const Numbers x = hn::LoadU(d, &points.x[i]);
      const Numbers y = hn::LoadU(d, &points.y[i]);
      const Numbers z = hn::LoadU(d, &points.z[i]);
      const Numbers l1_distance =
          hn::Add(hn::Abs(hn::Sub(x, a.x)), hn::Add(hn::Abs(hn::Sub(y, a.y)), hn::Abs(hn::Sub(z, a.z))));
      const auto is_near = hn::Le(hn::LoadU(d, squared + (i - begin)), hn::MulAdd(edge, l1_distance, least));
      const auto is_candidate = hn::And(hn::FirstN(d, end - i), is_near);
      count = copy_selected_points(points, i, is_candidate, nearby, count);
    }
    squared += end - begin;
  }
  nearby.count = count;
}

/// Computes the triangle of the nearest point for each of a block's 64 cells, given the centre of the first, and
/// returns the cells farther than r from all points. The four layers of 16 cells share the distances in the plane.
std::uint64_t nearest_of_cells(const NearbyPoints& points, const Eigen::Vector3f& first, float r2,
                               std::int32_t* triangles) {
  const hn::CappedTag<float, 16> d;
  const hn::RebindToSigned<decltype(d)> di;
  alignas(64) std::array<float, 16> cell_x;
  alignas(64) std::array<float, 16> cell_y;
  for (std::size_t i = 0; i < 16; ++i) {
    cell_x[i] = first.x() + static_cast<float>(i % 4);
    const std::size_t row = i / 4;
    cell_y[i] = first.y() + static_cast<float>(row);
  }
  const std::size_t n = points.count;
  std::uint64_t free = 0;
  for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(d)) {
    const auto cx = hn::Load(d, cell_x.data() + lane);
    const auto cy = hn::Load(d, cell_y.data() + lane);
    auto best0 = hn::Set(d, std::numeric_limits<float>::infinity());
    auto best1 = best0;
    auto best2 = best0;
    auto best3 = best0;
    auto index0 = hn::Zero(di);
    auto index1 = index0;
    auto index2 = index0;
    auto index3 = index0;
    for (std::size_t i = 0; i < n; ++i) {
      const auto dx = hn::Sub(hn::Set(d, points.x[i]), cx);
      const auto dy = hn::Sub(hn::Set(d, points.y[i]), cy);
      const auto flat = hn::MulAdd(dx, dx, hn::Mul(dy, dy));
      const float up = points.z[i] - first.z();
      const auto number = hn::Set(di, static_cast<std::int32_t>(i));
      const auto improve = [&](float dz, auto& best, auto& best_index) {
        const auto sum = hn::Add(flat, hn::Set(d, dz * dz));
        const auto better = hn::Lt(sum, best);
        best = hn::Min(sum, best);
        best_index = hn::IfThenElse(hn::RebindMask(di, better), number, best_index);
      };
      improve(up, best0, index0);
      improve(up - 1, best1, index1);
      improve(up - 2, best2, index2);
      improve(up - 3, best3, index3);
    }
    const auto finish = [&](std::size_t layer, const auto& best, const auto& index) {
      const std::size_t cell = 16 * layer + lane;
      hn::StoreU(hn::GatherIndex(di, points.triangle.data(), index), di, triangles + cell);
      std::array<std::uint8_t, 8> bytes{};
      hn::StoreMaskBits(d, hn::Gt(best, hn::Set(d, r2)), bytes.data());
      free |= (std::uint64_t{bytes[0]} | std::uint64_t{bytes[1]} << 8U) << cell;
    };
    finish(0, best0, index0);
    finish(1, best1, index1);
    finish(2, best2, index2);
    finish(3, best3, index3);
  }
  return free;
}

}  // namespace
}  // namespace shapegauge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shapegauge {

HWY_EXPORT(squared_distances_to);
HWY_EXPORT(nearest_of_cells);
HWY_EXPORT(indices_up_to);
HWY_EXPORT(measure_from_centre);
HWY_EXPORT(keep_candidates);

namespace {

/// Distance from the centre of a block to the centre of its farthest cell.
const double block_radius = std::sqrt(3.0) * (block_edge - 1) / 2;
const double cell_diagonal = std::sqrt(3.0);

/// Collects the runs of the neighbourhood, and makes room for their points.
void collect_runs(const BlockGrid& grid, const GridPoints& points, const Eigen::Vector3i& block,
                  const BlockNeighbourhood& around, NearbyPoints& nearby) {
  nearby.runs.clear();
  std::size_t count = 0;
  for (const auto& [j, k, along] : around.rows) {
    const int y = block.y() + j;
    const int z = block.z() + k;
    if (y < 0 || y >= grid.blocks.y() || z < 0 || z >= grid.blocks.z()) continue;
    const int low = std::max(block.x() - along, 0);
    const int high = std::min(block.x() + along, grid.blocks.x() - 1);
    const std::size_t row = grid.block_index({0, y, z});
    const std::uint32_t begin = points.first[row + static_cast<std::size_t>(low)];
    const std::uint32_t end = points.first[row + static_cast<std::size_t>(high) + 1];
    if (begin == end) continue;
    nearby.runs.push_back({begin, end});
    count += end - begin;
  }
  if (nearby.squared.size() >= count + grid_padding) return;
  for (std::vector<float>* values : {&nearby.squared, &nearby.x, &nearby.y, &nearby.z})
    values->resize(count + grid_padding);
  nearby.triangle.resize(count + grid_padding);
}

}  // namespace

float squared_distances(const float* x, const float* y, const float* z, std::size_t n, const Eigen::Vector3f& from,
                        float* squared) {
  return HWY_DYNAMIC_DISPATCH(squared_distances_to)(x, y, z, n, from, squared);
}

std::size_t indices_within(const float* numbers, std::size_t n, float limit, std::uint32_t* indices) {
  return HWY_DYNAMIC_DISPATCH(indices_up_to)(numbers, n, limit, indices);
}

BlockNeighbourhood::BlockNeighbourhood(double within) : distance(within) {
  // Number of blocks along an axis within the distance, given the squared distance along the other axes.
  const auto blocks_within = [&](double squared_across) {
    const double rest2 = distance * distance - squared_across;
    return rest2 < 0 ? -1 : static_cast<int>(std::floor(std::sqrt(rest2) / block_edge)) + 1;
  };
  const auto gap = [](int blocks) { return block_edge * std::max(0, std::abs(blocks) - 1); };
  const int reach = blocks_within(0);
  for (int k = -reach; k <= reach; ++k) {
    for (int j = -reach; j <= reach; ++j) {
      const int along = blocks_within(std::pow(gap(j), 2) + std::pow(gap(k), 2));
      if (along >= 0) rows.push_back({j, k, along});
    }
  }
}

BlockKind classify_block(const BlockGrid& grid, const GridSurface& surface, std::uint32_t block,
                         const BlockNeighbourhood& around, NearbyPoints& nearby, BoundaryBlock& found) {
  const Eigen::Vector3i coordinates = grid.block_at(block);
  collect_runs(grid, surface.points, coordinates, around, nearby);
  const Eigen::Vector3f centre = ((coordinates.cast<float>().array() + 0.5F) * block_edge).matrix();
  HWY_DYNAMIC_DISPATCH(measure_from_centre)(surface.points, centre, nearby);
  const double distance = std::sqrt(static_cast<double>(nearby.nearest_squared));
  if (distance > around.distance + block_radius) return BlockKind::free;
  if (distance + block_radius + cell_diagonal < grid.r) return BlockKind::covered;
  HWY_DYNAMIC_DISPATCH(keep_candidates)(surface.points, nearby);
  const Eigen::Vector3f first = (coordinates.cast<float>().array() * block_edge + 0.5F).matrix();
  found.index = block;
  found.free =
      HWY_DYNAMIC_DISPATCH(nearest_of_cells)(nearby, first, static_cast<float>(grid.r * grid.r), found.nearest.data());
  return BlockKind::mixed;
}

}  // namespace shapegauge
#endif  // HWY_ONCE
