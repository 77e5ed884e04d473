// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/shape/connectivity.h"

#include <array>
#include <bit>
#include <tuple>
#include <utility>

#include "shapegauge/core/base/interruption.h"

namespace shapegauge {

namespace {

/// Returns, for each of `count` elements, the first equal one. Uses a hash table with open addressing.
template <typename Hash, typename Equal>
std::vector<std::int32_t> first_of_equal(std::size_t count, const Hash& hash, const Equal& equal) {
  std::vector<std::int32_t> slots(std::bit_ceil(2 * count + 1), -1);
  const std::size_t mask = slots.size() - 1;
  std::vector<std::int32_t> first(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t slot = hash(i) & mask;
    while (slots[slot] >= 0 && !equal(static_cast<std::size_t>(slots[slot]), i)) slot = (slot + 1) & mask;
    if (slots[slot] < 0) slots[slot] = static_cast<std::int32_t>(i);
    first[i] = slots[slot];
  }
  return first;
}

/// Returns a hash of three numbers.
std::size_t hash_of(const std::array<std::uint64_t, 3>& numbers) {
  std::uint64_t result = 0;
  for (const std::uint64_t number : numbers) {
    result ^= number;
    result *= 0x9e3779b97f4a7c15ULL;
    result ^= result >> 32U;
  }
  return static_cast<std::size_t>(result);
}

/// Returns the welded corners of a triangle.
std::array<std::int32_t, 3> corner_positions(const Triangles& triangles, Eigen::Index triangle,
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
    const auto iterator_at = [&](std::size_t i) { return counted.values.begin() + static_cast<std::ptrdiff_t>(i); };
    std::sort(iterator_at(counted.first[v]), iterator_at(counted.first[v + 1]),
              [](const HalfEdge& a, const HalfEdge& b) {
                return std::tie(a.high, a.triangle) < std::tie(b.high, b.triangle);
              });
  }
  return std::move(counted.values);
}

/// Returns true if there are edges, and all of them satisfy a condition.
template <typename Condition>
bool all_edges(std::span<const HalfEdge> uses, Condition condition) {
  bool all = !uses.empty();
  for_each_edge(uses, [&](std::span<const HalfEdge> edge) { all = all && condition(edge); });
  return all;
}

bool has_even_number(std::span<const HalfEdge> edge) { return edge.size() % 2 == 0; }

}  // namespace

std::vector<std::int32_t> welded_vertices(const Points& vertices) {
  const auto position = [&](std::size_t v) { return vertices.row(static_cast<Eigen::Index>(v)); };
  const auto hash = [&](std::size_t v) {
    std::array<std::uint64_t, 3> bits{};
    for (int k = 0; k < 3; ++k)
      bits[k] = std::bit_cast<std::uint64_t>(position(v)[k] + 0.0);  // the same for both zeros
    return hash_of(bits);
  };
  return first_of_equal(static_cast<std::size_t>(vertices.rows()), hash,
                        [&](std::size_t a, std::size_t b) { return position(a) == position(b); });
}

std::vector<std::int32_t> first_duplicates(const Triangles& triangles, std::span<const std::int32_t> merged) {
  std::vector<std::array<std::uint64_t, 3>> corners(static_cast<std::size_t>(triangles.rows()));
  for (std::size_t f = 0; f < corners.size(); ++f) {
    const auto [a, b, c] = corner_positions(triangles, static_cast<Eigen::Index>(f), merged);
    const auto [low, high] = std::minmax({a, b, c});
    const std::int32_t middle = a ^ b ^ c ^ low ^ high;
    corners[f] = {static_cast<std::uint64_t>(low), static_cast<std::uint64_t>(middle),
                  static_cast<std::uint64_t>(high)};
  }
  return first_of_equal(
      corners.size(), [&](std::size_t f) { return hash_of(corners[f]); },
      [&](std::size_t f, std::size_t g) { return corners[f] == corners[g]; });
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
    const std::array<std::int32_t, 3> corners = corner_positions(triangles, f, welding.vertices);
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

std::vector<HalfEdge> surface_half_edges(const Shape& shape, const Welding& welding) {
  std::vector<HalfEdge> uses = half_edges(shape.triangles, welding);
  if (all_edges(uses, has_even_number)) return uses;
  std::vector<HalfEdge> of_others = uses;
  std::erase_if(of_others, [&](const HalfEdge& use) { return is_degenerate(shape, use.triangle); });
  return all_edges(of_others, has_even_number) ? of_others : uses;
}

bool is_closed(const Shape& shape) {
  require_usable(shape);
  return all_edges(surface_half_edges(shape, welding_of(shape)), has_even_number);
}

bool is_closed_and_oriented(const Shape& shape) {
  require_usable(shape);
  return all_edges(surface_half_edges(shape, welding_of(shape)), [](std::span<const HalfEdge> edge) {
    return 2 * std::ranges::count(edge, true, &HalfEdge::forward) == std::ssize(edge);
  });
}

}  // namespace shapegauge
