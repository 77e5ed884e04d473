// SPDX-License-Identifier: GPL-3.0-or-later
// Positions in the lanes of vectors, compiled for each instruction set supported by Highway.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shapegauge/core/offset/offset_depth.cpp"
#include "shapegauge/core/offset/offset_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

#include "shapegauge/core/offset/mean_normals.h"
#include "shapegauge/core/offset/point_search.h"
#include "shapegauge/core/offset/search_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {
namespace {

/// In each lane, the closest of the triangles that the cells around a position store.
struct ClosestLanes {
  VectorLanes vector;  ///< from the closest point
  RealLanes squared;   ///< infinite if no cell has a triangle
  LaneBits touches_exterior;
};

ClosestLanes closest_around(const ExteriorGrid& exterior, const VectorLanes& positions) {
  const Vectors x = load(positions);
  std::array<TriangleLanes, cells_around_point> cells;
  ClosestLanes result;
  result.touches_exterior = bits_of(find_cell_triangles(exterior, lowest_cells_around(exterior, x), cells.data()));
  Reals least = real(infinity);
  Vectors closest = zero_vectors();
  for (TriangleLanes& cell : cells) {
    measure(exterior.surface().triangles.records(), x, cell);
    const Reals squared = load(cell.squared);
    closest = select(hn::Lt(squared, least), load(cell.vector), closest);
    least = hn::Min(squared, least);
  }
  store(closest, result.vector);
  store(least, result.squared);
  return result;
}

/// Computes the result of a task, given the squared distance of the triangles around it and the vector from the
/// closest.
void set_depth(const ExteriorGrid& exterior, ClosestTriangles& triangles, const ClosestLanes& closest, std::size_t lane,
               OffsetDepthTask& task) {
  const double r = exterior.grid().r;
  const bool touches_exterior = (closest.touches_exterior >> lane & 1U) != 0;
  auto squared = static_cast<double>(closest.squared[lane]);
  const double least = (1 - surface_slack) * r;
  const bool has_triangle = closest.squared[lane] < infinity;
  task.is_exterior = touches_exterior && squared >= least * least;
  task.depth = 1;
  if (task.is_exterior || !has_triangle) return;
  if (squared >= std::pow((1 - blend_depth) * r, 2)) {
    // A small depth must be accurate: a triangle that is nearest to no cell may be closer.
    const std::int32_t triangle = triangles.closest_near(task.x - closest.vector.at(lane), task.x);
    if (triangle >= 0) squared = std::min(squared, exterior.surface().triangles.squared_distance(task.x, triangle));
  }
  task.depth = std::max(1 - std::sqrt(squared) / r, 0.0);
}

void find_depths(const ExteriorGrid& exterior, ClosestTriangles& triangles, std::span<OffsetDepthTask> tasks) {
  VectorLanes positions;
  store(zero_vectors(), positions);
  std::array<OffsetDepthTask*, max_lanes> task_of{};
  const auto begin = [&](std::size_t lane, OffsetDepthTask& task) {
    positions.set(lane, task.x.cast<float>());
    task_of[lane] = &task;
  };
  const auto step = [&](LaneBits running, LaneBits /*started*/) {
    const ClosestLanes closest = closest_around(exterior, positions);
    for_each_lane(running, [&](std::size_t lane) { set_depth(exterior, triangles, closest, lane, *task_of[lane]); });
    return running;
  };
  run_in_lanes(tasks, begin, step);
}

}  // namespace
}  // namespace shapegauge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shapegauge {

HWY_EXPORT(find_depths);

void find_offset_depths(const ExteriorGrid& exterior, ClosestTriangles& closest, std::span<OffsetDepthTask> tasks) {
  if (!tasks.empty()) HWY_DYNAMIC_DISPATCH(find_depths)(exterior, closest, tasks);
}

}  // namespace shapegauge
#endif  // HWY_ONCE
