#include "shapegauge/core/shape/connectivity.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <tuple>
#include <utility>

#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

namespace {

/// Hash table of the first vertex at each position, with open addressing.
class PlaceTable {
 public:
  explicit PlaceTable(const Points& vertices)
      : vertices_(vertices), slots_(std::bit_ceil(2 * static_cast<std::size_t>(vertices.rows()) + 1), -1) {}

  std::int32_t first_at_place_of(std::int32_t vertex) {
    std::size_t slot = hash(vertex) % slots_.size();
    while (slots_[slot] >= 0 && vertices_.row(slots_[slot]) != vertices_.row(vertex)) slot = (slot + 1) % slots_.size();
    if (slots_[slot] < 0) slots_[slot] = vertex;
    return slots_[slot];
  }

 private:
  [[nodiscard]] std::size_t hash(std::int32_t vertex) const {
    std::uint64_t result = 0;
    for (int k = 0; k < 3; ++k) {
      result ^= std::bit_cast<std::uint64_t>(vertices_(vertex, k) + 0.0);  // the same for both zeros
      result *= 0x9e3779b97f4a7c15ULL;
      result ^= result >> 32U;
    }
    return static_cast<std::size_t>(result);
  }

  const Points& vertices_;
  std::vector<std::int32_t> slots_;
};

/// Returns the welded corners of a triangle.
std::array<std::int32_t, 3> corner_places(const Triangles& triangles, Eigen::Index triangle,
                                          std::span<const std::int32_t> merged) {
  std::array<std::int32_t, 3> corners{};
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] = merged[static_cast<std::size_t>(triangles(triangle, static_cast<Eigen::Index>(k)))];
  }
  return corners;
}

/// Sorts half-edges by (low, high, triangle).
std::vector<HalfEdge> sorted(const std::vector<HalfEdge>& uses, std::size_t vertices) {
  BucketSorted<HalfEdge> counted = bucket_sort(uses, vertices, [](const HalfEdge& use) { return use.low; });
  const SparseInterruptionCheck check;
  for (std::size_t v = 0; v < vertices; ++v) {
    check();
    const auto place = [&](std::size_t i) { return counted.values.begin() + static_cast<std::ptrdiff_t>(i); };
    std::sort(place(counted.first[v]), place(counted.first[v + 1]), [](const HalfEdge& a, const HalfEdge& b) {
      return std::tie(a.high, a.triangle) < std::tie(b.high, b.triangle);
    });
  }
  return std::move(counted.values);
}

/// Returns true if there are edges, and all of them satisfy a condition.
template <typename Condition>
bool all_edges(const Shape& shape, Condition condition) {
  require_usable(shape);
  const std::vector<HalfEdge> uses = half_edges(shape.triangles, welded_vertices(shape.vertices));
  bool all = !uses.empty();
  for_each_edge(uses, [&](std::span<const HalfEdge> edge) { all = all && condition(edge); });
  return all;
}

}  // namespace

std::vector<std::int32_t> welded_vertices(const Points& vertices) {
  PlaceTable places(vertices);
  std::vector<std::int32_t> merged(static_cast<std::size_t>(vertices.rows()));
  for (std::size_t v = 0; v < merged.size(); ++v) merged[v] = places.first_at_place_of(static_cast<std::int32_t>(v));
  return merged;
}

std::vector<std::int32_t> first_duplicates(const Triangles& triangles, std::span<const std::int32_t> merged) {
  struct SortedCorners {
    std::array<std::int32_t, 3> corners;
    std::int32_t triangle;
  };
  std::vector<SortedCorners> all(static_cast<std::size_t>(triangles.rows()));
  for (std::size_t f = 0; f < all.size(); ++f) {
    all[f] = {corner_places(triangles, static_cast<Eigen::Index>(f), merged), static_cast<std::int32_t>(f)};
    std::ranges::sort(all[f].corners);
  }
  auto [sorted, first] = bucket_sort(all, merged.size(), [](const SortedCorners& t) { return t.corners[0]; });
  std::vector<std::int32_t> result(all.size());
  for (std::size_t v = 0; v < merged.size(); ++v) {
    const auto of_vertex = std::span(sorted).subspan(first[v], first[v + 1] - first[v]);
    std::ranges::sort(of_vertex, {}, [](const SortedCorners& t) { return std::tie(t.corners, t.triangle); });
    for (std::size_t i = 0, leader = 0; i < of_vertex.size(); ++i) {
      if (of_vertex[i].corners != of_vertex[leader].corners) leader = i;
      result[static_cast<std::size_t>(of_vertex[i].triangle)] = of_vertex[leader].triangle;
    }
  }
  return result;
}

Welding welding_of(const Shape& shape) {
  Welding welding{welded_vertices(shape.vertices), {}};
  welding.triangles = first_duplicates(shape.triangles, welding.vertices);
  return welding;
}

std::vector<HalfEdge> half_edges(const Triangles& triangles, const Welding& welding) {
  std::vector<HalfEdge> uses;
  uses.reserve(3 * static_cast<std::size_t>(triangles.rows()));
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    if (!welding.is_distinct(f)) continue;
    const std::array<std::int32_t, 3> corners = corner_places(triangles, f, welding.vertices);
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t from = corners[k];
      const std::int32_t to = corners[(k + 1) % 3];
      uses.push_back({.low = std::min(from, to),
                      .high = std::max(from, to),
                      .triangle = static_cast<std::int32_t>(f),
                      .corner = static_cast<std::int8_t>(k),
                      .forward = from < to});
    }
  }
  return sorted(uses, welding.vertices.size());
}

std::vector<HalfEdge> half_edges(const Triangles& triangles, std::span<const std::int32_t> merged) {
  return half_edges(triangles, {{merged.begin(), merged.end()}, first_duplicates(triangles, merged)});
}

bool is_closed(const Shape& shape) {
  return all_edges(shape, [](std::span<const HalfEdge> edge) { return edge.size() % 2 == 0; });
}

bool is_closed_and_oriented(const Shape& shape) {
  return all_edges(shape, [](std::span<const HalfEdge> edge) {
    return 2 * std::ranges::count(edge, true, &HalfEdge::forward) == std::ssize(edge);
  });
}

}  // namespace shapegauge
