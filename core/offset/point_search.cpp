// SPDX-License-Identifier: GPL-3.0-or-later
// Loops over points, compiled for each instruction set supported by Highway.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shapegauge/core/offset/point_search.cpp"
#include "shapegauge/core/offset/point_search.h"

#include <algorithm>
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>
#include <limits>

#include "shapegauge/core/offset/point_groups-inl.h"
#include "shapegauge/core/offset/triangle_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shapegauge::HWY_NAMESPACE {
namespace {

/// Finds the points of the runs within a distance of x.
void points_within(const GridPoints& points, const std::vector<GridPoints::Run>& runs, const Eigen::Vector3f& x,
                   float distance, std::vector<std::uint32_t>& indices) {
  const PointLanes d;
  const QueryPoint from(x);
  const Numbers limit = hn::Set(d, distance * distance);
  for_each_group(runs, from, points.boxes, distance, [&](std::size_t group) HWY_ATTR {
    for (std::size_t i = group * PointBoxes::group_size; i < (group + 1) * PointBoxes::group_size; i += hn::Lanes(d)) {
      const Numbers squared = from.squared(&points.x[i], &points.y[i], &points.z[i]);
      for_each_lane_of(hn::Le(squared, limit),
                       [&](std::size_t lane) { indices.push_back(static_cast<std::uint32_t>(i + lane)); });
    }
  });
}

/// Copies the points of the runs whose coordinates differ from those of a centre by at most half an edge. Returns their
/// number.
std::size_t points_in_cube(const GridPoints& points, const std::vector<GridPoints::Run>& runs,
                           const Eigen::Vector3f& centre, float half_edge, CollectedPoints& found) {
  const PointLanes d;
  const QueryPoint from(centre);
  const Numbers limit = hn::Set(d, half_edge);
  std::size_t count = 0;
  for_each_vector_of_groups(runs, [&](std::size_t first, hn::Mask<PointLanes> is_group) HWY_ATTR {
    const auto is_near = hn::And(is_group, hn::Le(from.to_boxes(points.boxes, first).largest(), limit));
    for_each_lane_of(is_near, [&](std::size_t group) HWY_ATTR {
      const std::size_t begin = (first + group) * PointBoxes::group_size;
      for (std::size_t i = begin; i < begin + PointBoxes::group_size; i += hn::Lanes(d)) {
        const Numbers x = hn::LoadU(d, &points.x[i]);
        const Numbers y = hn::LoadU(d, &points.y[i]);
        const Numbers z = hn::LoadU(d, &points.z[i]);
        const auto is_inside = hn::Le(from.largest_difference(x, y, z), limit);
        count = copy_selected_points(points, i, is_inside, found, count);
      }
    });
  });
  return count;
}

/// Calls visit(squared distances from x, number of the first point) for vectors of points.
template <typename Visit>
HWY_INLINE void for_each_vector_of(const std::vector<PointBlock>& blocks, const Eigen::Vector3f& x,
                                   const Visit& visit) {
  const QueryPoint from(x);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    for (std::size_t lane = 0; lane < grid_padding; lane += hn::Lanes(PointLanes())) {
      visit(from.squared(&blocks[i].x[lane], &blocks[i].y[lane], &blocks[i].z[lane]), i * grid_padding + lane);
    }
  }
}

/// Smallest of a sequence of numbers. Of equal ones it is the first, whatever the width of vectors.
class FirstSmallest {
  using Indices = hn::RebindToSigned<PointLanes>;

 public:
  HWY_INLINE FirstSmallest()
      : smallest_(hn::Set(PointLanes(), std::numeric_limits<float>::infinity())), index_(hn::Set(Indices(), none)) {}

  HWY_INLINE void add(Numbers numbers, std::size_t first) {
    const auto is_smaller = hn::RebindMask(Indices(), hn::Lt(numbers, smallest_));
    const auto index = hn::Add(hn::Iota(Indices(), 0), hn::Set(Indices(), static_cast<std::int32_t>(first)));
    index_ = hn::IfThenElse(is_smaller, index, index_);
    smallest_ = hn::Min(numbers, smallest_);
  }

  /// Returns the number's position; `none` if no number is finite.
  [[nodiscard]] HWY_INLINE std::size_t index() const {
    const auto is_smallest = hn::RebindMask(Indices(), hn::Eq(smallest_, hn::MinOfLanes(PointLanes(), smallest_)));
    const auto candidates = hn::IfThenElse(is_smallest, index_, hn::Set(Indices(), none));
    return static_cast<std::size_t>(hn::GetLane(hn::MinOfLanes(Indices(), candidates)));
  }
  static constexpr std::int32_t none = std::numeric_limits<std::int32_t>::max();

 private:
  Numbers smallest_;
  hn::Vec<Indices> index_;
};

/// Returns the triangle of the point nearest to x; -1 if x is not finite.
std::int32_t triangle_of_nearest(const std::vector<PointBlock>& blocks, const Eigen::Vector3f& x) {
  FirstSmallest nearest;
  for_each_vector_of(blocks, x, [&](Numbers squared, std::size_t first) HWY_ATTR { nearest.add(squared, first); });
  const std::size_t found = nearest.index();
  return found == FirstSmallest::none ? -1 : blocks[found / grid_padding].triangle[found % grid_padding];
}

/// Writes the triangles of the points whose squared distance from x exceeds the smallest by at most the margin, padded
/// by repetition to whole vectors. Returns their number.
std::size_t find_candidates(const std::vector<PointBlock>& blocks, const Eigen::Vector3f& x, float margin,
                            std::vector<std::int32_t>& triangles) {
  const PointLanes d;
  if (triangles.size() < (blocks.size() + 1) * grid_padding) triangles.resize((blocks.size() + 1) * grid_padding);
  Numbers smallest = hn::Set(d, std::numeric_limits<float>::infinity());
  for_each_vector_of(blocks, x, [&](Numbers squared, std::size_t) HWY_ATTR { smallest = hn::Min(smallest, squared); });
  const Numbers limit = hn::Add(hn::MinOfLanes(d, smallest), hn::Set(d, margin));
  std::size_t count = 0;
  for_each_vector_of(blocks, x, [&](Numbers squared, std::size_t first) HWY_ATTR {
    const auto is_candidate = hn::Le(squared, limit);
    copy_selected(&blocks[first / grid_padding].triangle[first % grid_padding], is_candidate, &triangles[count]);
    count += hn::CountTrue(d, is_candidate);
  });
  std::fill_n(&triangles[count], grid_padding, triangles[0]);
  return count;
}

/// Returns the triangle closest to x of those whose points are nearly the nearest; -1 if x is not finite.
std::int32_t closest_of_candidates(const std::vector<PointBlock>& blocks, const float* records,
                                   const Eigen::Vector3f& x, float margin, std::vector<std::int32_t>& triangles) {
  const PointLanes d;
  const std::size_t count = find_candidates(blocks, x, margin, triangles);
  const LaneVectors<PointLanes> position{hn::Set(d, x.x()), hn::Set(d, x.y()), hn::Set(d, x.z())};
  FirstSmallest closest;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    closest.add(vectors_from_triangles(d, records, &triangles[i], position).squared, i);
  }
  const std::size_t found = closest.index();
  return found == FirstSmallest::none ? -1 : triangles[found];
}

}  // namespace
}  // namespace shapegauge::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shapegauge {

HWY_EXPORT(points_within);
HWY_EXPORT(points_in_cube);
HWY_EXPORT(triangle_of_nearest);
HWY_EXPORT(closest_of_candidates);

namespace {

/// Returns the edge of regions, in cells, that have up to about 130 points, or half as many where each search reads
/// them twice.
double edge_of_regions(const GridSurface& surface) {
  const double max_points = surface.squared_margin == 0 ? 130 : 65;
  constexpr double block_area = 1.25 * block_edge * block_edge;  // of a surface in a block, in the mean
  const double density = surface.points_per_block / block_area;
  const auto has_too_many_points = [&](double edge) {
    const double whole = edge + 2 * ClosestTriangles::reach;
    return density * whole * whole > max_points;
  };
  double edge = block_edge;
  while (edge > 0.5 && has_too_many_points(edge)) edge /= 2;
  return edge;
}

}  // namespace

void find_points_within(const BlockGrid& grid, const GridPoints& points, const Eigen::Vector3d& x, double distance,
                        std::vector<std::uint32_t>& indices) {
  indices.clear();
  thread_local std::vector<GridPoints::Run> runs;
  points.find_runs(grid, x, distance, runs);
  HWY_DYNAMIC_DISPATCH(points_within)(points, runs, x.cast<float>(), static_cast<float>(distance), indices);
}

ClosestTriangles::ClosestTriangles(const BlockGrid& grid, const GridSurface& surface)
    : grid_(grid), surface_(surface), edge_(edge_of_regions(surface)), shift_(edge_ > 1 ? edge_ / 2 : 0) {}

std::int32_t ClosestTriangles::closest_near(const Eigen::Vector3d& position, const Eigen::Vector3d& x) {
  const Eigen::Vector3i at = ((position.array() + shift_) / edge_).cast<int>();
  std::size_t index = 0;
  for (int k = 0; k < 3; ++k) {
    constexpr unsigned last = (1U << bits_per_axis) - 1;
    index |= std::size_t{static_cast<unsigned>(at[k]) & last} << (bits_per_axis * static_cast<unsigned>(k));
  }
  Region& region = regions_[index];
  if (region.position != at) {
    region.position = at;
    collect(edge_ * (at.cast<double>().array() + 0.5) - shift_, edge_ / 2 + reach, region.points);
  }
  return closest_of(region.points, x);
}

std::int32_t ClosestTriangles::closest_within(double distance, const Eigen::Vector3d& x) {
  collect(x, distance, points_within_);
  return closest_of(points_within_, x);
}

/// Collects the points whose coordinates differ from those of a centre by at most half an edge.
void ClosestTriangles::collect(const Eigen::Vector3d& centre, double half_edge, std::vector<PointBlock>& points) {
  surface_.points.find_runs(grid_, centre, half_edge, runs_);
  std::size_t most = grid_padding;
  for (const auto& [begin, end] : runs_) most += end - begin + 2 * grid_padding;  // the runs' first and last groups
  if (collected_.x.size() < most) {
    for (std::vector<float>* values : {&collected_.x, &collected_.y, &collected_.z}) values->resize(most);
    collected_.triangle.resize(most);
  }
  const std::size_t count = HWY_DYNAMIC_DISPATCH(points_in_cube)(surface_.points, runs_, centre.cast<float>(),
                                                                 static_cast<float>(half_edge), collected_);
  std::fill_n(&collected_.x[count], grid_padding, std::numeric_limits<float>::infinity());
  points.resize((count + grid_padding - 1) / grid_padding);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t first = i * grid_padding;
    std::copy_n(&collected_.x[first], grid_padding, points[i].x.begin());
    std::copy_n(&collected_.y[first], grid_padding, points[i].y.begin());
    std::copy_n(&collected_.z[first], grid_padding, points[i].z.begin());
    std::copy_n(&collected_.triangle[first], grid_padding, points[i].triangle.begin());
  }
}

std::int32_t ClosestTriangles::closest_of(const std::vector<PointBlock>& points, const Eigen::Vector3d& x) {
  if (points.empty()) return -1;
  if (surface_.squared_margin == 0) return HWY_DYNAMIC_DISPATCH(triangle_of_nearest)(points, x.cast<float>());
  return HWY_DYNAMIC_DISPATCH(closest_of_candidates)(points, surface_.triangles.records(), x.cast<float>(),
                                                     static_cast<float>(surface_.squared_margin), candidates_);
}

}  // namespace shapegauge
#endif  // HWY_ONCE
