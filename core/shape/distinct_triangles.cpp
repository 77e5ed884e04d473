// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/shape/distinct_triangles.h"

#include <numeric>
#include <span>
#include <utility>

#include "shapegauge/core/shape/connectivity.h"

namespace shapegauge {

namespace {

/// Returns 0, 1, ..., size - 1.
std::vector<std::int32_t> indices_up_to(Eigen::Index size) {
  std::vector<std::int32_t> numbers(static_cast<std::size_t>(size));
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

/// Computes DistinctTriangles::vertex_of from the result of first_duplicates().
std::vector<std::int32_t> vertices_of_first(const Shape& mesh, std::span<const std::int32_t> merged,
                                            std::span<const std::int32_t> first) {
  std::vector<bool> settled(merged.size());
  for (std::size_t f = 0; f < first.size(); ++f) {
    if (first[f] != static_cast<std::int32_t>(f)) continue;
    for (const std::int32_t vertex : mesh.triangles.row(first[f])) settled[static_cast<std::size_t>(vertex)] = true;
  }
  std::vector<std::int32_t> result = indices_up_to(mesh.vertices.rows());
  for (std::size_t f = 0; f < first.size(); ++f) {
    for (const std::int32_t vertex : mesh.triangles.row(static_cast<Eigen::Index>(f))) {
      const auto v = static_cast<std::size_t>(vertex);
      if (settled[v]) continue;
      settled[v] = true;
      for (const std::int32_t other : mesh.triangles.row(first[f])) {
        if (merged[static_cast<std::size_t>(other)] == merged[v]) result[v] = other;
      }
    }
  }
  return result;
}

}  // namespace

DistinctTriangles distinct_triangles(Shape shape) {
  DistinctTriangles result{.shape = std::move(shape), .triangle_of = {}, .vertex_of = {}};
  Shape& mesh = result.shape;
  result.vertex_of = indices_up_to(mesh.vertices.rows());
  if (is_cloud(mesh)) return result;
  const std::vector<std::int32_t> merged = welded_vertices(mesh.vertices);
  const std::vector<std::int32_t> first = first_duplicates(mesh.triangles, merged);
  std::vector<std::int32_t> retained = first;
  std::size_t count = 0;
  result.triangle_of = first;
  for (std::size_t f = 0; f < first.size(); ++f) {
    const auto first_copy = static_cast<std::size_t>(first[f]);  // before f, or f
    if (first_copy == f) {
      result.triangle_of[f] = static_cast<std::int32_t>(count);
      retained[count++] = first[f];
    } else {
      result.triangle_of[f] = result.triangle_of[first_copy];
    }
  }
  if (count == first.size()) return result;
  retained.resize(count);
  result.vertex_of = vertices_of_first(mesh, merged, first);
  mesh.triangles = mesh.triangles(retained, Eigen::all).eval();
  mesh.polygons = {};
  return result;
}

Shape without_duplicates(Shape shape) { return distinct_triangles(std::move(shape)).shape; }

}  // namespace shapegauge
