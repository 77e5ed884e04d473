#include "shapegauge/core/shape/distinct_triangles.h"

#include <numeric>
#include <utility>

#include "shapegauge/core/shape/connectivity.h"

namespace shapegauge {

namespace {

/// The numbers from 0 on.
std::vector<std::int32_t> counted_up(Eigen::Index size) {
  std::vector<std::int32_t> numbers(static_cast<std::size_t>(size));
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

/// By vertex: itself, or where the distinct triangles do not use it one of theirs at the same place.
std::vector<std::int32_t> used_instead(const Shape& distinct, const std::vector<bool>& used_before,
                                       std::span<const std::int32_t> merged) {
  const std::vector<bool> used = used_vertices(distinct);
  std::vector<std::int32_t> used_at(merged.size(), -1);
  for (const std::int32_t vertex : distinct.triangles.reshaped<Eigen::RowMajor>()) {
    std::int32_t& at = used_at[static_cast<std::size_t>(merged[static_cast<std::size_t>(vertex)])];
    if (at < 0) at = vertex;
  }
  std::vector<std::int32_t> result = counted_up(distinct.vertices.rows());
  for (std::size_t v = 0; v < result.size(); ++v) {
    if (used_before[v] && !used[v]) result[v] = used_at[static_cast<std::size_t>(merged[v])];
  }
  return result;
}

}  // namespace

DistinctTriangles distinct_triangles(Shape shape) {
  DistinctTriangles result{.shape = std::move(shape), .triangle_of = {}, .vertex_of = {}};
  Shape& mesh = result.shape;
  result.vertex_of = counted_up(mesh.vertices.rows());
  if (is_cloud(mesh)) return result;
  const std::vector<std::int32_t> merged = merged_by_place(mesh.vertices);
  const std::vector<std::int32_t> first = first_of_doubles(mesh.triangles, merged);
  std::vector<std::int32_t> kept = first;
  std::size_t count = 0;
  result.triangle_of = first;
  for (std::size_t f = 0; f < first.size(); ++f) {
    const auto own = static_cast<std::size_t>(first[f]);  // before f, or f
    if (own == f) {
      result.triangle_of[f] = static_cast<std::int32_t>(count);
      kept[count++] = first[f];
    } else {
      result.triangle_of[f] = result.triangle_of[own];
    }
  }
  if (count == first.size()) return result;
  kept.resize(count);
  const std::vector<bool> used = used_vertices(mesh);
  mesh.triangles = mesh.triangles(kept, Eigen::all).eval();
  result.vertex_of = used_instead(mesh, used, merged);
  return result;
}

Shape without_doubles(Shape shape) { return distinct_triangles(std::move(shape)).shape; }

}  // namespace shapegauge
