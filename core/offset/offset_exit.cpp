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

/// The cells of a block around the box from a to b, which are no nearer to its sides than half a cell.
std::uint64_t cells_along(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  constexpr std::array<std::uint64_t, 3> every{0x1111111111111111, 0x0001000100010001, 1};
  std::uint64_t cells = ~std::uint64_t{0};
  for (int k = 0; k < 3; ++k) {
    const int low = std::max(static_cast<int>(std::min(a[k], b[k]) - 0.5), 0);
    const int high = std::min(static_cast<int>(std::max(a[k], b[k]) + 0.5), block_edge - 1);
    const int layer = 1 << (2 * k);  // bits
    const std::uint64_t from_low = ~std::uint64_t{0} << static_cast<unsigned>(low * layer);
    const std::uint64_t to_high = ~std::uint64_t{0} >> static_cast<unsigned>(64 - (high + 1) * layer);
    cells &= (from_low & to_high) * every[static_cast<std::size_t>(k)];
  }
  return cells;
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
  // After a step so short, in parts of r, the triangles seen from its end are those seen from its beginning.
  constexpr double nearly = 0.02;
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
    // Where no cell that the way through the block comes near is exterior, one of the eight around x may be only near
    // the block's sides.
    const Eigen::Vector3d from = x - (block_edge * block).cast<double>();
    const double inner = leave_inside(from, inverse);
    if (inner > 0 && (exterior.exterior_cells(index) & cells_along(from, from + inner * direction)) == 0) {
      t += inner;
      continue;
    }
    const CellsAround around = cells_around(exterior, x);
    if (!around.touches_exterior) {
      t += leave_cube<1>(x, inverse, 0.5);
      continue;
    }
    // Balls about the closest points of the triangles around cover a stretch of the ray; the farthest end counts.
    if (!vectors_around(exterior, around, x, vectors)) return t;
    double covered = end_of_balls(vectors, direction, r);
    t += covered;
    if (covered > nearly * r) continue;
    // Perhaps a triangle that no cell knows of, near the one that is closest.
    const auto closest = static_cast<std::size_t>(std::min_element(vectors.squared.begin(), vectors.squared.end()) -
                                                  vectors.squared.begin());
    const std::int32_t triangle =
        closest_triangle_about(grid, exterior.surface(), x - vectors.vector(closest), closest_reach, x);
    const bool is_known =
        std::find(around.triangles.begin(), around.triangles.end(), triangle) != around.triangles.end();
    if (triangle < 0 || is_known) return t;
    std::array<std::int32_t, TriangleTable::at_once> triangles;
    triangles.fill(triangle);
    exterior.surface().triangles.vectors_to(origin + t * direction, triangles.data(), vectors);
    covered = end_of_balls(vectors, direction, r);
    t += covered;
    if (covered <= nearly * r) return t;
  }
  return t;
}

}  // namespace shapegauge
