#include "shapegauge/core/preparation/vertex_neighbours.h"

#include <algorithm>
#include <utility>

#include "shapegauge/core/shape/merged_vertices.h"
#include "shapegauge/core/shape/validity.h"

namespace shapegauge {

namespace {

using Pair = std::pair<std::int32_t, std::int32_t>;

/// The ends of all edges, either way round, each once, sorted.
std::vector<Pair> neighbouring_places(const Triangles& triangles, const std::vector<std::int32_t>& merged) {
  std::vector<Pair> pairs;
  pairs.reserve(6 * static_cast<std::size_t>(triangles.rows()));
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const std::int32_t a = merged[static_cast<std::size_t>(triangles(f, k))];
      const std::int32_t b = merged[static_cast<std::size_t>(triangles(f, (k + 1) % 3))];
      if (a == b) continue;
      pairs.emplace_back(a, b);
      pairs.emplace_back(b, a);
    }
  }
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

/// Which vertices a triangle uses.
std::vector<bool> used_vertices(const Shape& shape) {
  std::vector<bool> used(static_cast<std::size_t>(shape.vertices.rows()));
  for (const std::int32_t vertex : shape.triangles.reshaped()) used[static_cast<std::size_t>(vertex)] = true;
  return used;
}

}  // namespace

VertexNeighbours vertex_neighbours(const Shape& shape) {
  require_usable(shape);
  const std::vector<std::int32_t> merged = merged_by_place(shape.vertices);
  const std::vector<Pair> pairs = neighbouring_places(shape.triangles, merged);
  const std::vector<bool> used = used_vertices(shape);
  VertexNeighbours result;
  result.first.reserve(merged.size() + 1);
  result.neighbours.reserve(pairs.size());
  for (std::size_t v = 0; v < merged.size(); ++v) {
    result.first.push_back(result.neighbours.size());
    if (!used[v]) continue;
    for (auto pair = std::ranges::lower_bound(pairs, merged[v], {}, &Pair::first);
         pair != pairs.end() && pair->first == merged[v]; ++pair) {
      result.neighbours.push_back(pair->second);
    }
  }
  result.first.push_back(result.neighbours.size());
  return result;
}

}  // namespace shapegauge
