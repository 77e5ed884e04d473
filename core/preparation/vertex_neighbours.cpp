#include "shapegauge/core/preparation/vertex_neighbours.h"

#include <algorithm>
#include <span>

#include "shapegauge/core/shape/counting_sort.h"
#include "shapegauge/core/shape/merged_vertices.h"
#include "shapegauge/core/shape/validity.h"

namespace shapegauge {

namespace {

/// An edge, seen from one of its ends.
struct Neighbour {
  std::int32_t of;
  std::int32_t vertex;
};

/// The places at the other ends of each place's edges, sorted; those of edges with two triangles twice.
CountedByKey<Neighbour> neighbouring_places(const Triangles& triangles, const std::vector<std::int32_t>& merged) {
  std::vector<Neighbour> neighbours;
  neighbours.reserve(6 * static_cast<std::size_t>(triangles.rows()));
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const std::int32_t a = merged[static_cast<std::size_t>(triangles(f, k))];
      const std::int32_t b = merged[static_cast<std::size_t>(triangles(f, (k + 1) % 3))];
      if (a == b) continue;
      neighbours.push_back({a, b});
      neighbours.push_back({b, a});
    }
  }
  CountedByKey<Neighbour> counted = counted_by_key(neighbours, merged.size(), [](const Neighbour& n) { return n.of; });
  for (std::size_t v = 0; v < merged.size(); ++v) {
    const std::span all(counted.values);
    std::ranges::sort(all.subspan(counted.first[v], counted.first[v + 1] - counted.first[v]), {}, &Neighbour::vertex);
  }
  return counted;
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
  const CountedByKey<Neighbour> places = neighbouring_places(shape.triangles, merged);
  const std::vector<bool> used = used_vertices(shape);
  VertexNeighbours result;
  result.first.reserve(merged.size() + 1);
  result.neighbours.reserve(places.values.size() / 2);
  for (std::size_t v = 0; v < merged.size(); ++v) {
    result.first.push_back(result.neighbours.size());
    if (!used[v]) continue;
    const auto place = static_cast<std::size_t>(merged[v]);
    for (std::size_t i = places.first[place]; i < places.first[place + 1]; ++i) {
      const std::int32_t vertex = places.values[i].vertex;
      if (i > places.first[place] && vertex == places.values[i - 1].vertex) continue;
      result.neighbours.push_back(vertex);
    }
  }
  result.first.push_back(result.neighbours.size());
  return result;
}

}  // namespace shapegauge
