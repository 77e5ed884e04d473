#include "shapegauge/core/offset/offset_exit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "shapegauge/core/offset/block_distances.h"
#include "shapegauge/core/offset/triangle_table.h"

namespace shapegauge {

namespace {

/// Where the ray leaves the cube of so many cells that holds x, whose coordinates are not negative. The cubes begin at
/// multiples of their edge, shifted.
template <int edge>
double leave_cube(const Eigen::Vector3d& x, const Eigen::Vector3d& inverse, double shift) {
  constexpr double inverse_edge = 1.0 / edge;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double place = (x[k] - shift) * inverse_edge;
    // The conversion rounds as floor does, from -1 on by one less, which leads on as well.
    const double low = static_cast<int>(place);
    const double way = inverse[k] > 0 ? low + 1 - place : low - place;
    least = std::min(least, way * edge * inverse[k]);
  }
  return std::max(least, 0.0) + 1e-6;
}

/// Where the ray leaves the block without its outermost half cells, x being relative to the block's corner; 0 where x
/// is not in there.
double leave_inside(const Eigen::Vector3d& x, const Eigen::Vector3d& inverse) {
  constexpr double low = 0.5;
  constexpr double high = block_edge - 0.5;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    if (x[k] < low || x[k] > high) return 0;
    least = std::min(least, ((inverse[k] > 0 ? high : low) - x[k]) * inverse[k]);
  }
  return least + 1e-6;
}

/// How far along the ray the balls of radius r about the ends of the vectors cover it; 0 where none does.
double end_of_balls(const TriangleTable::Vectors& vectors, const Eigen::Vector3d& direction, double r) {
  const double outside = r * (1 + 1e-4);
  double end = 0;
  for (std::size_t i = 0; i < TriangleTable::at_once; ++i) {
    const double squared = static_cast<double>(vectors.squared[i]);
    if (squared >= r * r) continue;
    const double along = vectors.vector(i).dot(direction);
    end = std::max(end, std::sqrt(along * along + outside * outside - squared) - along);
  }
  return end;
}

}  // namespace

double offset_exit(const ExteriorGrid& exterior, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
  const BlockGrid& grid = exterior.grid();
  const Eigen::Vector3d inverse = direction.cwiseInverse();
  const double r = grid.r;
  TriangleTable::Vectors vectors;
  double t = r;
  for (int step = 0; step < 100000; ++step) {
    const Eigen::Vector3d x = origin + t * direction;
    const Eigen::Vector3i block = (x / block_edge).cast<int>();
    if (!grid.has_block(block)) return t;
    const std::size_t index = grid.block_index(block);
    if (!exterior.is_near_exterior(index)) {
      t += leave_cube<block_edge>(x, inverse, 0);
      continue;
    }
    // Where no cell of the block is exterior, one of the eight around x may be only near the block's sides.
    const double inner = leave_inside(x - (block_edge * block).cast<double>(), inverse);
    if (inner > 0 && !exterior.has_exterior(index)) {
      t += inner;
      continue;
    }
    if (!touches_exterior(exterior, x)) {
      t += leave_cube<1>(x, inverse, 0.5);
      continue;
    }
    const CellsAround around = cells_around(exterior, x);
    // Balls about the closest points of the triangles around cover a stretch of the ray; the farthest end counts.
    if (!vectors_around(exterior, around, x, vectors)) return t;
    double covered = end_of_balls(vectors, direction, r);
    if (covered == 0) {
      // Perhaps a triangle that no cell knows of, near the one that is closest.
      const auto closest = static_cast<std::size_t>(std::min_element(vectors.squared.begin(), vectors.squared.end()) -
                                                    vectors.squared.begin());
      const std::int32_t triangle =
          closest_triangle_about(grid, exterior.surface(), x - vectors.vector(closest), 0.7, x);
      if (triangle < 0) return t;
      std::array<std::int32_t, TriangleTable::at_once> triangles;
      triangles.fill(triangle);
      exterior.surface().triangles.vectors_to(x, triangles.data(), vectors);
      covered = end_of_balls(vectors, direction, r);
      if (covered == 0) return t;
    }
    t += std::max(covered, 1e-4 * r);
  }
  return t;
}

}  // namespace shapegauge
