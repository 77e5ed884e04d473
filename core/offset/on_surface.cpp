// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/offset/on_surface.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "shapegauge/core/offset/point_search.h"
#include "shapegauge/core/spatial/closest_point.h"

namespace shapegauge {

namespace {

/// Tests in double precision: single precision loses the interior of triangles a thousand times as long as wide. The
/// edges are tested as well, for triangles too thin for double precision.
bool is_on_likely_triangle(const BlockGrid& grid, const Shape& shape, std::int32_t triangle, const Eigen::Vector3d& p,
                           double near_enough) {
  if (is_cloud(shape)) return false;
  const auto is_near = [&](const Eigen::Vector3d& x) { return (x - p).norm() <= near_enough; };
  const Triangle t = triangle_in_cells(grid, shape, triangle);
  return is_near(closest_point(t, p)) || is_near(closest_point_on_segment(t.a, t.b, p)) ||
         is_near(closest_point_on_segment(t.b, t.c, p)) || is_near(closest_point_on_segment(t.c, t.a, p));
}

/// Tests the triangles of the points near p.
bool is_on_any_triangle(const ExteriorGrid& exterior, const GridPoints& points, const Eigen::Vector3d& p,
                        double near_enough, std::vector<std::uint32_t>& nearby) {
  if (points.size() == 0) return false;
  // Maximum distance of a point of a triangle from its samples: the apex of an equilateral one.
  const double reach = 1.5 * exterior.surface().spacing + near_enough;
  find_points_within(exterior.grid(), points, p, reach, nearby);
  std::array<std::int32_t, TriangleTable::batch_size> triangles{};
  TriangleTable::Vectors vectors;
  for (std::size_t i = 0; i < nearby.size(); i += triangles.size()) {
    for (std::size_t lane = 0; lane < triangles.size(); ++lane) {
      triangles[lane] = points.triangle[nearby[std::min(i + lane, nearby.size() - 1)]];
    }
    exterior.surface().triangles.vectors_to(p, triangles.data(), vectors);
    const float least = *std::min_element(vectors.squared.begin(), vectors.squared.end());
    if (static_cast<double>(least) <= near_enough * near_enough) return true;
  }
  return false;
}

}  // namespace

std::vector<std::int32_t> likely_triangles(const Shape& shape, Eigen::Index samples) {
  std::vector<std::int32_t> likely(static_cast<std::size_t>(samples), 0);
  if (samples == (is_cloud(shape) ? shape.vertices.rows() : shape.triangles.rows())) {
    std::iota(likely.begin(), likely.end(), 0);
  } else if (samples == shape.vertices.rows()) {
    for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
      for (int k = 0; k < 3; ++k)
        likely[static_cast<std::size_t>(shape.triangles(f, k))] = static_cast<std::int32_t>(f);
    }
  }
  return likely;
}

bool is_on_surface(const ExteriorGrid& exterior, const Shape& shape, const Eigen::Vector3d& p, std::int32_t triangle,
                   std::vector<std::uint32_t>& nearby) {
  const GridSurface& surface = exterior.surface();
  const BlockGrid& grid = exterior.grid();
  const double near_enough = std::max(1e-3 * grid.r, 1e-6 / grid.cell);  // displacement of a sample by rounding
  return surface.triangles.is_over_face(p, triangle, near_enough) ||
         surface.triangles.squared_distance(p, triangle) <= near_enough * near_enough ||
         is_on_likely_triangle(grid, shape, triangle, p, near_enough) ||
         is_on_any_triangle(exterior, surface.points, p, near_enough, nearby) ||
         is_on_any_triangle(exterior, surface.omitted, p, near_enough, nearby);
}

}  // namespace shapegauge
