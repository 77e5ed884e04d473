#include "shapegauge/core/offset/block_grid.h"

#include <algorithm>
#include <cmath>
#include <tbb/parallel_for.h>

#include "shapegauge/core/spatial/closest_point.h"

namespace shapegauge {

namespace {

Triangle triangle_of(const BlockGrid& grid, const Shape& shape, Eigen::Index f) {
  const auto corner = [&](int k) { return grid.to_cells(shape.vertices.row(shape.triangles(f, k)).transpose()); };
  return {corner(0), corner(1), corner(2)};
}

/// Columns of points on a triangle, across its longest edge: each point stands for a part no larger than the spacing.
struct Columns {
  Eigen::Vector3d from, along;  ///< the longest edge
  Eigen::Vector3d up;           ///< from the foot of the apex to the apex
  double foot;                  ///< where on the edge that is, as a part of it
  double height, spacing;
  int count;

  Columns(const Triangle& t, double at_most) : spacing(at_most) {
    const std::array<Eigen::Vector3d, 3> corners{t.a, t.b, t.c};
    std::size_t longest = 0;
    double longest2 = -1;
    for (std::size_t k = 0; k < 3; ++k) {
      const double length2 = (corners[(k + 1) % 3] - corners[k]).squaredNorm();
      if (length2 <= longest2) continue;
      longest2 = length2;
      longest = k;
    }
    from = corners[longest];
    along = corners[(longest + 1) % 3] - from;
    const Eigen::Vector3d across = corners[(longest + 2) % 3] - from;
    foot = longest2 > 0 ? std::clamp(along.dot(across) / longest2, 0.0, 1.0) : 0;
    up = across - foot * along;
    height = up.norm();
    count = std::max(1, static_cast<int>(std::ceil(std::sqrt(longest2) / spacing)));
  }

  template <typename Visit>
  void for_each_point(const Visit& visit) const {
    for (int column = 0; column < count; ++column) {
      const double at = (column + 0.5) / count;
      const double part = at < foot ? at / foot : (1 - at) / (1 - foot);  // of the height
      const int points = std::max(1, static_cast<int>(std::ceil(part * height / spacing)));
      for (int i = 0; i < points; ++i) visit(from + at * along + (i + 0.5) / points * part * up);
    }
  }
};

}  // namespace

BlockGrid::BlockGrid(const Eigen::AlignedBox3d& bounds, double offset, double h) : cell(h), r(offset / h) {
  // Two cells above r are as far as anybody looks for points, and whole blocks are looked at.
  const double margin = block_edge * h * (std::ceil((r + 2) / block_edge) + 1);
  origin = bounds.min() - Eigen::Vector3d::Constant(margin);
  const Eigen::Vector3d extent = bounds.sizes() + Eigen::Vector3d::Constant(2 * margin);
  blocks = (extent / (block_edge * h)).array().ceil().cast<int>();
}

std::size_t BlockGrid::block_count() const {
  return static_cast<std::size_t>(blocks.x()) * static_cast<std::size_t>(blocks.y()) *
         static_cast<std::size_t>(blocks.z());
}

void dilate(const BlockGrid& grid, std::vector<std::uint8_t>& marked, int reach) {
  std::vector<std::uint8_t> line;
  const std::array<std::size_t, 3> size{static_cast<std::size_t>(grid.blocks.x()),
                                        static_cast<std::size_t>(grid.blocks.y()),
                                        static_cast<std::size_t>(grid.blocks.z())};
  const std::array<std::size_t, 3> stride{1, size[0], size[0] * size[1]};
  for (int step = 0; step < reach; ++step) {
    std::vector<std::uint8_t> wider;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      wider = marked;
      const std::size_t s = stride[axis];
      const std::size_t span = s * size[axis];
      for (std::size_t start = 0; start < marked.size(); start += span) {
        for (std::size_t i = start + s; i < start + span; ++i) {
          wider[i] |= marked[i - s];
          wider[i - s] |= marked[i];
        }
      }
      marked.swap(wider);
    }
  }
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

GridSurface::GridSurface(const BlockGrid& grid, const Shape& shape, double apart, bool parallel) : spacing(apart) {
  const bool cloud = is_cloud(shape);
  const auto n = static_cast<std::size_t>(cloud ? shape.vertices.rows() : shape.triangles.rows());
  triangles.resize(n);
  struct Point {
    float x, y, z;
    std::int32_t triangle;
    std::uint32_t block;
  };
  constexpr std::size_t chunk_size = 2048;
  std::vector<std::vector<Point>> chunks((n + chunk_size - 1) / chunk_size);
  const auto fill = [&](std::size_t chunk) {
    std::vector<Point>& points = chunks[chunk];
    const std::size_t end = std::min(n, (chunk + 1) * chunk_size);
    points.reserve(2 * (end - chunk * chunk_size));
    for (std::size_t f = chunk * chunk_size; f < end; ++f) {
      const auto row = static_cast<Eigen::Index>(f);
      Triangle t;
      if (cloud) {
        t.a = t.b = t.c = grid.to_cells(shape.vertices.row(row).transpose());
      } else {
        t = triangle_of(grid, shape, row);
      }
      triangles.set(f, t.a.cast<float>(), t.b.cast<float>(), t.c.cast<float>());
      Columns(t, spacing).for_each_point([&](const Eigen::Vector3d& at) {
        points.push_back({static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(at.z()),
                          static_cast<std::int32_t>(f),
                          static_cast<std::uint32_t>(grid.block_index(grid.block_of(at)))});
      });
    }
  };
  if (parallel) {
    tbb::parallel_for(std::size_t{0}, chunks.size(), fill);
  } else {
    for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk) fill(chunk);
  }
  first.assign(grid.block_count() + 1, 0);
  for (const auto& points : chunks) {
    for (const Point& point : points) ++first[point.block + 1];
  }
  for (std::size_t block = 1; block < first.size(); ++block) first[block] += first[block - 1];
  // A triangle's own points are no farther than this from any place on it.
  if (first.back() > 2 * n) hidden = 0.5 * spacing * spacing;
  x.resize(first.back() + grid_padding);
  y.resize(first.back() + grid_padding);
  z.resize(first.back() + grid_padding);
  triangle.resize(first.back());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (const auto& points : chunks) {
    for (const Point& point : points) {
      const std::uint32_t place = next[point.block]++;
      x[place] = point.x;
      y[place] = point.y;
      z[place] = point.z;
      triangle[place] = point.triangle;
    }
  }
}

}  // namespace shapegauge
