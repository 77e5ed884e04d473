// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/preparation/diagnostics.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <vector>

#include "shapegauge/core/preparation/denoise.h"
#include "shapegauge/core/preparation/gap_size.h"
#include "shapegauge/core/preparation/outliers.h"
#include "shapegauge/core/preparation/stray_normals.h"
#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/distinct_triangles.h"

namespace shapegauge {

namespace {

using CornerIndices = std::array<std::int32_t, 3>;

/// Returns the triangles' corners as welded vertices.
std::vector<CornerIndices> merged_corners(const Triangles& triangles, const std::vector<std::int32_t>& merged) {
  std::vector<CornerIndices> corners(static_cast<std::size_t>(triangles.rows()));
  for (std::size_t f = 0; f < corners.size(); ++f) {
    const auto triangle = triangles.row(static_cast<Eigen::Index>(f));
    for (std::size_t k = 0; k < 3; ++k) {
      corners[f][k] = merged[static_cast<std::size_t>(triangle[static_cast<Eigen::Index>(k)])];
    }
  }
  return corners;
}

std::size_t count_unreferenced(const Shape& shape) {
  if (is_cloud(shape)) return 0;
  return static_cast<std::size_t>(std::ranges::count(used_vertices(shape), false));
}

std::size_t count_degenerate(const Shape& shape) {
  std::size_t count = 0;
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) count += is_degenerate(shape, f) ? 1 : 0;
  return count;
}

std::size_t count_duplicates(const Welding& welding) {
  std::size_t count = 0;
  for (Eigen::Index f = 0; f < std::ssize(welding.triangles); ++f) count += welding.is_distinct(f) ? 0 : 1;
  return count;
}

/// Counts the components connected through vertices by union-find.
std::size_t count_components(const std::vector<CornerIndices>& corners, std::size_t vertices) {
  DisjointSets parts;
  parts.grow_to(vertices);
  for (const CornerIndices& triangle : corners) {
    for (std::size_t k = 1; k < 3; ++k) parts.join(triangle[0], triangle[k]);
  }
  std::vector<bool> is_part(vertices);
  for (const CornerIndices& triangle : corners) is_part[static_cast<std::size_t>(parts.find(triangle[0]))] = true;
  return static_cast<std::size_t>(std::ranges::count(is_part, true));
}

void diagnose_edges(const Shape& shape, const Welding& welding, ShapeDiagnostics& found) {
  const std::vector<HalfEdge> uses = surface_half_edges(shape, welding);
  std::vector<double> boundary;
  found.closed = !uses.empty();
  for_each_edge(uses, [&](std::span<const HalfEdge> edge) {
    ++found.edges;
    if (edge.size() % 2 != 0) found.closed = false;
    if (edge.size() == 1)
      boundary.push_back((shape.vertices.row(edge[0].low) - shape.vertices.row(edge[0].high)).norm());
    if (edge.size() > 2) ++found.non_manifold_edges;
    if (edge.size() == 2 && edge[0].forward == edge[1].forward) ++found.inconsistent_edges;
  });
  found.boundary_edges = boundary.size();
  std::ranges::sort(boundary);  // the same sum for any order of the edges
  found.boundary_length = std::accumulate(boundary.begin(), boundary.end(), 0.0);
}

void diagnose_gaps_and_noise(const Shape& shape, const Welding& welding, ShapeDiagnostics& found) {
  if (!found.closed) {
    const GapSizes gaps = gap_sizes(shape);
    found.gap_size = gaps.widest;
    found.closable_gap = gaps.closable;
  }
  found.outliers = outlier_count(shape);
  found.stray_normals = has_stray_normals(shape);
  found.point_spacing = point_spacing(shape);
  const VertexNeighbours neighbours = vertex_neighbours(shape, welding);
  const NoiseLevel noise = noise_level(shape, neighbours, welding);
  found.noise_deviation = noise.deviation;
  found.noisy = is_noisy(noise, neighbours);
}

}  // namespace

ShapeDiagnostics diagnose(const Shape& shape) {
  require_usable(shape);
  ShapeDiagnostics found;
  const Welding welding = welding_of(shape);
  const std::vector<std::int32_t>& merged = welding.vertices;
  found.vertices = merged.size();
  for (std::size_t i = 0; i < merged.size(); ++i) {
    if (static_cast<std::size_t>(merged[i]) != i) ++found.coincident_vertices;
  }
  found.unreferenced_vertices = count_unreferenced(shape);
  found.diagonal = bounding_box_diagonal(shape);
  found.triangles = static_cast<std::size_t>(shape.triangles.rows());
  found.area = surface_area(shape, welding);
  found.degenerate_triangles = count_degenerate(shape);
  found.components = count_components(merged_corners(shape.triangles, merged), merged.size());
  found.duplicate_triangles = count_duplicates(welding);
  diagnose_edges(shape, welding, found);
  diagnose_gaps_and_noise(shape, welding, found);
  return found;
}

double signed_volume(const Shape& original) {
  const Shape shape = without_duplicates(original);
  const Eigen::Vector3d centre = bounding_box(shape).center();
  double six_volumes = 0;
  for (const auto& triangle : shape.triangles.rowwise()) {
    const auto corner = [&](int i) { return (shape.vertices.row(triangle[i]).transpose() - centre).eval(); };
    six_volumes += corner(0).dot(corner(1).cross(corner(2)));
  }
  return six_volumes / 6;
}

}  // namespace shapegauge
