#include "shapegauge/core/preparation/vertex_neighbours.h"

#include <algorithm>
#include <utility>

namespace shapegauge {

VertexNeighbours vertex_neighbours(const Shape& shape) {
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
  pairs.reserve(6 * static_cast<std::size_t>(shape.triangles.rows()));
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const std::int32_t a = shape.triangles(f, k);
      const std::int32_t b = shape.triangles(f, (k + 1) % 3);
      if (a == b) continue;
      pairs.emplace_back(a, b);
      pairs.emplace_back(b, a);
    }
  }
  std::ranges::sort(pairs);
  const auto repeated = std::ranges::unique(pairs);
  pairs.erase(repeated.begin(), repeated.end());

  VertexNeighbours result;
  result.first.assign(static_cast<std::size_t>(shape.vertices.rows()) + 1, 0);
  result.neighbours.reserve(pairs.size());
  for (const auto& [vertex, neighbour] : pairs) {
    ++result.first[static_cast<std::size_t>(vertex) + 1];
    result.neighbours.push_back(neighbour);
  }
  for (std::size_t v = 1; v < result.first.size(); ++v) result.first[v] += result.first[v - 1];
  return result;
}

}  // namespace shapegauge
