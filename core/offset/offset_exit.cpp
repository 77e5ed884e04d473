#include "shapegauge/core/offset/offset_exit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "shapegauge/core/offset/block_distances.h"
#include "shapegauge/core/offset/triangle_table.h"

namespace shapegauge {

namespace {

/// Ray through the cubes between the cells' centres, in cells relative to the first centre.
struct Ray {
  Eigen::Vector3d origin, direction, inverse;

  [[nodiscard]] Eigen::Vector3d at(double t) const { return origin + t * direction; }
};

/// Returns the distance from x at which the ray leaves the cube, of a lattice with this edge, that contains x. The
/// coordinates of x are not negative.
template <int edge>
double distance_to_cube_exit(const Eigen::Vector3d& x, const Ray& ray) {
  constexpr double inverse_edge = 1.0 / edge;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double place = x[k] * inverse_edge;
    // Truncation equals floor except between -1 and 0, where the ray still advances.
    const double low = static_cast<int>(place);
    const double way = ray.inverse[k] > 0 ? low + 1 - place : low - place;
    least = std::min(least, way * edge * ray.inverse[k]);
  }
  return std::max(least, 0.0) + 1e-6;
}

/// Returns the cubes between the centres of a block's cells and their neighbours that have an exterior corner. Each is
/// the bit of its lowest cell.
std::uint64_t cubes_at_exterior(const ExteriorGrid& exterior, const Eigen::Vector3i& block) {
  constexpr std::uint64_t low_x = 0x1111111111111111;
  constexpr std::uint64_t low_y = 0x000F000F000F000F;
  const BlockGrid& grid = exterior.grid();
  const auto cells = [&](int i, int j, int k) {
    const Eigen::Vector3i at = (block + Eigen::Vector3i(i, j, k)).cwiseMin(grid.blocks - Eigen::Vector3i::Ones());
    return exterior.exterior_cells(grid.block_index(at));
  };
  const auto along_x = [&](int j, int k) {
    const std::uint64_t own = cells(0, j, k);
    return own | (own & ~low_x) >> 1U | (cells(1, j, k) & low_x) << 3U;
  };
  const auto along_y = [&](int k) {
    const std::uint64_t own = along_x(0, k);
    return own | (own & ~low_y) >> 4U | (along_x(1, k) & low_y) << 12U;
  };
  const std::uint64_t own = along_y(0);
  return own | own >> 16U | along_y(1) << 48U;
}

/// Returns the cubes of a block that intersect the box from a to b, both relative to its corner.
std::uint64_t cubes_along(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  constexpr std::array<std::uint64_t, 3> every{0x1111111111111111, 0x0001000100010001, 1};
  std::uint64_t cubes = ~std::uint64_t{0};
  for (int k = 0; k < 3; ++k) {
    const int low = std::clamp(static_cast<int>(std::min(a[k], b[k])), 0, block_edge - 1);
    const int high = std::clamp(static_cast<int>(std::max(a[k], b[k])), 0, block_edge - 1);
    const int layer = 1 << (2 * k);  // bits
    const std::uint64_t from_low = ~std::uint64_t{0} << static_cast<unsigned>(low * layer);
    const std::uint64_t to_high = ~std::uint64_t{0} >> static_cast<unsigned>(64 - (high + 1) * layer);
    cubes &= (from_low & to_high) * every[static_cast<std::size_t>(k)];
  }
  return cubes;
}

/// Returns the parameter, from t on, at which the ray enters a cube with an exterior corner or leaves the grid.
double next_exterior_cube(const ExteriorGrid& exterior, const Ray& ray, double t) {
  const BlockGrid& grid = exterior.grid();
  while (true) {
    const Eigen::Vector3d x = ray.at(t);
    const Eigen::Vector3i block = (x / block_edge).cast<int>();
    if (!grid.has_block(block)) return t;
    const double end = t + distance_to_cube_exit<block_edge>(x, ray);
    if (exterior.is_near_exterior(grid.block_index(block))) {
      const Eigen::Vector3d corner = (block_edge * block).cast<double>();
      const std::uint64_t candidates =
          cubes_at_exterior(exterior, block) & cubes_along(x - corner, ray.at(end) - corner);
      while (candidates != 0 && t < end) {
        const Eigen::Vector3d from = ray.at(t);
        const Eigen::Vector3i cube = (from - corner).cast<int>().cwiseMax(0).cwiseMin(block_edge - 1);
        if ((candidates >> static_cast<unsigned>(cube.x() + 4 * cube.y() + 16 * cube.z()) & 1U) != 0) return t;
        t += distance_to_cube_exit<1>(from, ray);
      }
    }
    t = end;
  }
}

/// Returns the end of the part of a ray covered by the balls of radius r about the triangles' closest points; 0 if none
/// covers its origin.
double end_of_balls(const TriangleTable::Vectors& vectors, const Eigen::Vector3d& direction, double r) {
  const double outside = r * (1 + 1e-4);
  double end = 0;
  for (std::size_t i = 0; i < TriangleTable::batch_size; ++i) {
    const auto squared = static_cast<double>(vectors.squared[i]);
    if (squared >= r * r) continue;
    const double along = vectors.vector(i).dot(direction);
    end = std::max(end, std::sqrt(along * along + outside * outside - squared) - along);
  }
  return end;
}

}  // namespace

double offset_exit(const ExteriorGrid& exterior, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
  constexpr int max_steps = 100000;
  // After a step below this length, in units of r, the surrounding triangles are the same.
  constexpr double negligible = 0.02;
  const double r = exterior.grid().r;
  const Ray ray{(origin.array() - 0.5).matrix(), direction, direction.cwiseInverse()};
  TriangleTable::Vectors vectors;
  double t = r;
  for (int step = 0; step < max_steps; ++step) {
    t = next_exterior_cube(exterior, ray, t);
    const Eigen::Vector3d x = origin + t * direction;
    const CellsAround around = cells_around(exterior, x);
    // The balls about the closest points of the surrounding triangles cover a part of the ray; advance to its end.
    if (!vectors_around(exterior, around, x, vectors)) return t;
    double covered = end_of_balls(vectors, direction, r);
    t += covered;
    if (covered > negligible * r) continue;
    // A triangle that is nearest to none of the cells may be closer; it is near the closest one.
    const auto closest = static_cast<std::size_t>(std::min_element(vectors.squared.begin(), vectors.squared.end()) -
                                                  vectors.squared.begin());
    const std::int32_t triangle =
        closest_triangle_near(exterior.grid(), exterior.surface(), x - vectors.vector(closest), closest_reach, x);
    const bool is_known =
        std::find(around.triangles.begin(), around.triangles.end(), triangle) != around.triangles.end();
    if (triangle < 0 || is_known) return t;
    std::array<std::int32_t, TriangleTable::batch_size> triangles;
    triangles.fill(triangle);
    exterior.surface().triangles.vectors_to(origin + t * direction, triangles.data(), vectors);
    covered = end_of_balls(vectors, direction, r);
    t += covered;
    if (covered <= negligible * r) return t;
  }
  return t;
}

}  // namespace shapegauge
