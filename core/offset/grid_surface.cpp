// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/offset/grid_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <tbb/enumerable_thread_specific.h>

#include "shapegauge/core/base/parallel.h"
#include "shapegauge/core/offset/grid_layout.h"

namespace shapegauge {

namespace {

/// Edge of the cubes in each of which one small triangle is retained, in units of r.
constexpr double cube_edge = 1.0 / 16;

/// Returns the number of parts of at most max_length in a length. Faster than std::ceil.
int part_count(double length, double max_length) {
  if (length <= max_length) return 1;
  const double exact = length / max_length;
  const int whole = static_cast<int>(exact);
  return whole < exact ? whole + 1 : whole;
}

constexpr int max_parts = 8;
/// By number of parts of 1, the middle of each.
constexpr auto middles = [] {
  std::array<std::array<double, max_parts>, max_parts + 1> table{};
  for (std::size_t parts = 1; parts < table.size(); ++parts) {
    for (std::size_t i = 0; i < parts; ++i) {
      table[parts][i] = (static_cast<double>(i) + 0.5) / static_cast<double>(parts);
    }
  }
  return table;
}();

/// Returns the middle of part i of n equal parts of 1. The table saves most divisions.
double middle_of_part(int i, int n) {
  return n <= max_parts ? middles[static_cast<std::size_t>(n)][static_cast<std::size_t>(i)] : (i + 0.5) / n;
}

/// Columns of points on a triangle, perpendicular to its longest edge. Each point represents a part no larger than the
/// spacing.
struct Columns {
  Eigen::Vector3d from, along;  ///< the longest edge
  Eigen::Vector3d up;           ///< from the foot of the apex to the apex
  double foot;                  ///< position of the foot on the edge, from 0 to 1
  double longest = 0;           ///< length of that edge
  double height, spacing;
  int count;

  Columns(const Triangle& t, double max_length) : spacing(max_length) {
    const std::array<Eigen::Vector3d, 3> corners{t.a, t.b, t.c};
    std::size_t first = 0;
    double longest2 = -1;
    for (std::size_t k = 0; k < 3; ++k) {
      const double length2 = (corners[(k + 1) % 3] - corners[k]).squaredNorm();
      if (length2 <= longest2) continue;
      longest2 = length2;
      first = k;
    }
    longest = std::sqrt(longest2);
    from = corners[first];
    along = corners[(first + 1) % 3] - from;
    const Eigen::Vector3d across = corners[(first + 2) % 3] - from;
    foot = longest2 > 0 ? std::clamp(along.dot(across) / longest2, 0.0, 1.0) : 0;
    up = across - foot * along;
    height = up.norm();
    count = part_count(longest, spacing);
  }

  template <typename Visit>
  void for_each_point(const Visit& visit) const {
    for (int column = 0; column < count; ++column) {
      const double at = middle_of_part(column, count);
      const double part = at < foot ? at / foot : (1 - at) / (1 - foot);  // of the height
      const int points = part_count(part * height, spacing);
      const Eigen::Vector3d bottom = from + at * along;
      for (int i = 0; i < points; ++i) visit(bottom + middle_of_part(i, points) * part * up);
    }
  }
};

struct Point {
  float x, y, z, area;
  std::int32_t triangle;
  std::uint32_t block;
  std::uint16_t code;  ///< its position in the block, along a Morton curve
  bool is_small;       ///< its triangle is small enough to be represented by another
};

/// Block that contains a point, and position of the point in it.
struct BlockPosition {
  std::uint32_t block;
  std::uint16_t code;  ///< along a Morton curve through the parts of the block
};

/// Finds blocks, whose eight parts along each axis are sorted along a Morton curve.
class BlockFinder {
 public:
  explicit BlockFinder(const BlockGrid& grid)
      : stride_y_(static_cast<std::uint32_t>(grid.blocks.x())),
        stride_z_(static_cast<std::uint32_t>(grid.blocks.x()) * static_cast<std::uint32_t>(grid.blocks.y())) {
    static_assert(max_grid_blocks < std::numeric_limits<std::uint32_t>::max());
  }

  /// Finds the block and the cube in it that contain a position in cells.
  [[nodiscard]] BlockPosition find(const Eigen::Vector3d& at) const {
    const std::uint32_t x = part(at.x());
    const std::uint32_t y = part(at.y());
    const std::uint32_t z = part(at.z());
    return {x / parts + stride_y_ * (y / parts) + stride_z_ * (z / parts),
            static_cast<std::uint16_t>(spread[x % parts] | spread[y % parts] << 1U | spread[z % parts] << 2U)};
  }

 private:
  static constexpr std::uint32_t parts = 8;
  static constexpr std::array<std::uint16_t, parts> spread{0, 1, 8, 9, 64, 65, 72, 73};
  static std::uint32_t part(double coordinate) {
    constexpr double per_cell = static_cast<double>(parts) / block_edge;
    // Signed, since rounding may make a coordinate of 0 negative.
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(coordinate * per_cell));
  }

  std::uint32_t stride_y_, stride_z_;
};

/// Samples the triangles from begin to end, and sets their records.
std::vector<Point> sampled_points(const BlockGrid& grid, const Shape& shape, double spacing, std::size_t begin,
                                  std::size_t end, TriangleTable& triangles) {
  std::vector<Point> points;
  points.reserve(2 * (end - begin));
  const BlockFinder blocks(grid);
  for (std::size_t f = begin; f < end; ++f) {
    const auto row = static_cast<Eigen::Index>(f);
    Triangle t;
    if (is_cloud(shape)) {
      t.a = t.b = t.c = grid.to_cells(shape.vertices.row(row).transpose());
    } else {
      t = triangle_in_cells(grid, shape, row);
    }
    triangles.set(f, t.a.cast<float>(), t.b.cast<float>(), t.c.cast<float>());
    const Columns columns(t, spacing);
    const bool is_small = columns.longest <= cube_edge * grid.r;
    const std::size_t first_point = points.size();
    columns.for_each_point([&](const Eigen::Vector3d& at) {
      const BlockPosition position = blocks.find(at);
      points.push_back({static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(at.z()), 0,
                        static_cast<std::int32_t>(f), position.block, position.code, is_small});
    });
    const double area = (t.b - t.a).cross(t.c - t.a).norm() / 2;
    const auto share = static_cast<float>(area / static_cast<double>(points.size() - first_point));
    for (std::size_t i = first_point; i < points.size(); ++i) points[i].area = share;
  }
  return points;
}

/// Selection of the points of a block that represent others.
class CubeRepresentatives {
 public:
  explicit CubeRepresentatives(const BlockGrid& grid)
      : edge_(cube_edge * grid.r), cubes_along_(static_cast<std::size_t>(std::ceil(block_edge / edge_)) + 1) {
    representatives_.assign(cubes_along_ * cubes_along_ * cubes_along_, none);
  }

  /// Keeps the point nearest to the centre of each cube, which receives the area of the others, and marks these as
  /// omitted.
  void omit(const BlockGrid& grid, std::span<Point> points, std::span<std::uint8_t> is_omitted) {
    const Eigen::Vector3f corner = (block_edge * grid.block_at(points.front().block)).cast<float>();
    cubes_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!points[i].is_small) continue;
      const Eigen::Vector3f position =
          (Eigen::Vector3f(points[i].x, points[i].y, points[i].z) - corner) / static_cast<float>(edge_);
      // Rounding may move a point just outside its block.
      const Eigen::Array3i cube = position.cast<int>().array().max(0).min(static_cast<int>(cubes_along_) - 1);
      cubes_[i].off_centre = (position.array() - cube.cast<float>() - 0.5F).matrix().squaredNorm();
      cubes_[i].number =
          (static_cast<std::size_t>(cube.z()) * cubes_along_ + static_cast<std::size_t>(cube.y())) * cubes_along_ +
          static_cast<std::size_t>(cube.x());
      std::uint32_t& representative = representatives_[cubes_[i].number];
      if (representative == none || cubes_[i].off_centre < cubes_[representative].off_centre)
        representative = static_cast<std::uint32_t>(i);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!points[i].is_small) continue;
      const std::uint32_t representative = representatives_[cubes_[i].number];
      if (representative == i) continue;
      is_omitted[i] = 1;
      points[representative].area += points[i].area;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i].is_small) representatives_[cubes_[i].number] = none;
    }
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  struct Cube {
    std::size_t number;
    float off_centre;  ///< squared
  };
  double edge_;
  std::size_t cubes_along_;
  std::vector<std::uint32_t> representatives_;
  std::vector<Cube> cubes_;
};

/// All points, sorted by block.
struct SortedPoints {
  std::vector<Point> list;
  std::vector<std::size_t> begins;       ///< first point of each block with points; one more entry at the end
  std::vector<std::uint8_t> is_omitted;  ///< per point
};

/// Returns the bounding boxes of the groups of the points.
PointBoxes boxes_of_groups(const GridPoints& points, std::size_t count, bool parallel) {
  constexpr std::size_t size = PointBoxes::group_size;
  const std::size_t groups = (count + size - 1) / size;
  PointBoxes boxes;
  const std::array<const float*, 3> coordinates{points.x.data(), points.y.data(), points.z.data()};
  for_each_index(parallel, std::size_t{0}, coordinates.size(), [&](std::size_t k) {
    boxes.low[k].resize(groups + grid_padding);
    boxes.high[k].resize(groups + grid_padding);
    for (std::size_t i = 0; i < groups; ++i) {
      const auto first = static_cast<std::ptrdiff_t>(size * i);
      const auto in_group = static_cast<Eigen::Index>(std::min(size, count - size * i));
      const Eigen::Map<const Eigen::ArrayXf> group(coordinates[k] + first, in_group);
      boxes.low[k][i] = group.minCoeff();
      boxes.high[k][i] = group.maxCoeff();
    }
  });
  return boxes;
}

/// Copies the omitted points of a block, or the others, to the result from index `next` on.
void copy_block(const SortedPoints& all, std::size_t block, std::uint8_t which, std::size_t next, GridPoints& result) {
  constexpr unsigned index_bits = 32;
  thread_local std::vector<std::uint64_t> order;  // code in the high bits, index in the low ones
  order.clear();
  for (std::size_t i = all.begins[block]; i < all.begins[block + 1]; ++i) {
    if (all.is_omitted[i] == which) order.push_back(std::uint64_t{all.list[i].code} << index_bits | i);
  }
  std::sort(order.begin(), order.end());
  for (const std::uint64_t entry : order) {
    const Point& point = all.list[static_cast<std::uint32_t>(entry)];
    result.x[next] = point.x;
    result.y[next] = point.y;
    result.z[next] = point.z;
    result.area[next] = point.area;
    result.triangle[next++] = point.triangle;
  }
}

/// Returns the omitted points, or the others.
GridPoints selected(const BlockGrid& grid, const SortedPoints& all, std::uint8_t which, bool parallel) {
  GridPoints result;
  const auto count = static_cast<std::size_t>(std::count(all.is_omitted.begin(), all.is_omitted.end(), which));
  if (count == 0) return result;
  for (AlignedArray<float>* values : {&result.x, &result.y, &result.z}) {
    values->resize(count + grid_padding, std::numeric_limits<float>::infinity());
  }
  result.area.resize(count + grid_padding);
  result.triangle.resize(count + grid_padding, -1);
  result.first.resize(grid.block_count() + 1);
  for (std::size_t i = 0; i < all.list.size(); ++i) {
    if (all.is_omitted[i] == which) ++result.first[all.list[i].block + 1];
  }
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
  for_each_index(parallel, std::size_t{0}, all.begins.size() - 1, [&](std::size_t block) {
    copy_block(all, block, which, result.first[all.list[all.begins[block]].block], result);
  });
  result.boxes = boxes_of_groups(result, count, parallel);
  return result;
}

/// Returns the points of all chunks, sorted by block.
std::vector<Point> sorted_by_blocks(const std::vector<std::vector<Point>>& chunks, std::size_t blocks) {
  std::vector<std::uint32_t> first(blocks + 1);
  for (const auto& chunk : chunks) {
    for (const Point& point : chunk) ++first[point.block + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Point> points(first[blocks]);
  for (const auto& chunk : chunks) {
    for (const Point& point : chunk) points[first[point.block]++] = point;
  }
  return points;
}

}  // namespace

void GridPoints::find_runs(const BlockGrid& grid, const Eigen::Vector3d& position, double reach,
                           std::vector<Run>& runs) const {
  runs.clear();
  const Eigen::Vector3i low = grid.block_of(position.array() - reach).cwiseMax(0);
  const Eigen::Vector3i high = grid.block_of(position.array() + reach).cwiseMin(grid.blocks - Eigen::Vector3i::Ones());
  for (int k = low.z(); k <= high.z(); ++k) {
    for (int j = low.y(); j <= high.y(); ++j) {
      const std::size_t row = grid.block_index({0, j, k});
      const Run run{first[row + static_cast<std::size_t>(low.x())],
                    first[row + static_cast<std::size_t>(high.x()) + 1]};
      if (run.begin != run.end) runs.push_back(run);
    }
  }
}

Triangle triangle_in_cells(const BlockGrid& grid, const Shape& shape, Eigen::Index triangle) {
  const auto corner = [&](int k) {
    return grid.to_cells(shape.vertices.row(shape.triangles(triangle, k)).transpose());
  };
  return {corner(0), corner(1), corner(2)};
}

SurfaceExtent::SurfaceExtent(const Shape& shape)
    : pieces(static_cast<double>(is_cloud(shape) ? shape.vertices.rows() : shape.triangles.rows())) {
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const auto corner = [&](int k) -> Eigen::Vector3d { return shape.vertices.row(shape.triangles(f, k)); };
    const Eigen::Vector3d ab = corner(1) - corner(0);
    const Eigen::Vector3d ac = corner(2) - corner(0);
    lengths += std::sqrt(std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()}));
    area += ab.cross(ac).norm() / 2;
  }
}

GridSurface::GridSurface(const BlockGrid& grid, const Shape& shape, double max_spacing, bool parallel)
    : spacing(max_spacing) {
  const auto n = static_cast<std::size_t>(is_cloud(shape) ? shape.vertices.rows() : shape.triangles.rows());
  triangles.resize(n);
  const auto for_each = [parallel](std::size_t count, const auto& task) {
    for_each_index(parallel, std::size_t{0}, count, task);
  };
  constexpr std::size_t chunk_size = 2048;
  std::vector<std::vector<Point>> chunks((n + chunk_size - 1) / chunk_size);
  for_each(chunks.size(), [&](std::size_t chunk) {
    chunks[chunk] =
        sampled_points(grid, shape, spacing, chunk * chunk_size, std::min(n, (chunk + 1) * chunk_size), triangles);
  });
  SortedPoints all{sorted_by_blocks(chunks, grid.block_count()), {}, {}};
  chunks.clear();
  // No point of a triangle is farther than this from the nearest of its samples.
  if (all.list.size() > 2 * n) squared_margin = 0.5 * spacing * spacing;
  for (std::size_t i = 0; i < all.list.size(); ++i) {
    if (i == 0 || all.list[i].block != all.list[i - 1].block) all.begins.push_back(i);
  }
  all.begins.push_back(all.list.size());
  all.is_omitted.assign(all.list.size(), 0);
  tbb::enumerable_thread_specific<CubeRepresentatives> cubes([&] { return CubeRepresentatives(grid); });
  for_each(all.begins.size() - 1, [&](std::size_t block) {
    const std::size_t begin = all.begins[block];
    const std::size_t count = all.begins[block + 1] - begin;
    if (count < 2) return;
    cubes.local().omit(grid, {&all.list[begin], count}, {&all.is_omitted[begin], count});
  });
  points = selected(grid, all, 0, parallel);
  omitted = selected(grid, all, 1, parallel);
  points_per_block = static_cast<double>(points.size()) / std::max(1.0, static_cast<double>(all.begins.size() - 1));
}

}  // namespace shapegauge
