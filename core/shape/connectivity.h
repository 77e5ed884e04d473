#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <tuple>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Values sorted by key, stably.
template <typename Value>
struct CountedByKey {
  std::vector<Value> values;
  std::vector<std::size_t> first;  ///< of each key, and the number of values at the end
};

/// Counting sort by keys from 0 to keys - 1, in linear time. key(value) gives the key.
template <typename Value, typename Key>
CountedByKey<Value> counted_by_key(const std::vector<Value>& values, std::size_t keys, Key key) {
  CountedByKey<Value> result{std::vector<Value>(values.size()), std::vector<std::size_t>(keys + 1, 0)};
  for (const Value& value : values) ++result.first[static_cast<std::size_t>(key(value)) + 1];
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
  std::vector<std::size_t> next = result.first;
  for (const Value& value : values) result.values[next[static_cast<std::size_t>(key(value))]++] = value;
  return result;
}

/// Disjoint sets of the numbers from 0 on (union-find).
class DisjointSets {
 public:
  [[nodiscard]] std::size_t size() const { return parent_.size(); }

  /// Adds numbers up to the size, each in a set of its own.
  void grow_to(std::size_t size) {
    while (parent_.size() < size) parent_.push_back(static_cast<std::int32_t>(parent_.size()));
  }

  /// The least number in the set of i.
  std::int32_t find(std::int32_t i) {
    while (parent(i) != i) i = parent(i) = parent(parent(i));
    return i;
  }

  void join(std::int32_t i, std::int32_t j) {
    i = find(i);
    j = find(j);
    if (i != j) parent(std::max(i, j)) = std::min(i, j);
  }

 private:
  std::int32_t& parent(std::int32_t i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<std::int32_t> parent_;
};

/// For each vertex, the index of the first vertex at exactly the same place, which may be its own.
std::vector<std::int32_t> merged_by_place(const Points& vertices);

/// For each triangle the first one with the same three corners, in any order: its own index unless it is a double.
/// Vertices are named as by merged_by_place().
std::vector<std::int32_t> first_of_doubles(const Triangles& triangles, std::span<const std::int32_t> merged);

/// A half-edge: a side of a triangle, and the edge that it lies on. Vertices are named as by merged_by_place().
struct EdgeUse {
  std::int32_t low;       ///< the edge's lesser vertex
  std::int32_t high;      ///< the edge's greater vertex
  std::int32_t triangle;  ///< whose side it is
  std::int8_t corner;     ///< at which the side begins; it leads to the next one
  bool forward;           ///< whether it leads from the lesser vertex to the greater

  [[nodiscard]] bool same_edge(const EdgeUse& other) const { return low == other.low && high == other.high; }
};

/// All sides of the triangles whose corners are at three places, sorted by edge, those of an edge by triangle. Of
/// doubled triangles only the first has sides (first_of_doubles()).
std::vector<EdgeUse> edge_uses(const Triangles& triangles, std::span<const std::int32_t> merged);

/// Calls visit(std::span<const EdgeUse>) with the uses of each edge.
template <typename Visit>
void for_each_edge(std::span<const EdgeUse> uses, Visit visit) {
  for (std::size_t begin = 0; begin < uses.size();) {
    std::size_t end = begin + 1;
    while (end < uses.size() && uses[end].same_edge(uses[begin])) ++end;
    visit(uses.subspan(begin, end - begin));
    begin = end;
  }
}

/// Whether the triangles separate an inside from an outside by ray parity: every edge belongs to an even number of
/// triangles. Vertices at the same place are merged, triangles without area and doubles are left out, and orientation
/// plays no part. False without triangles. Throws InputError for an unusable shape (require_usable()).
bool is_watertight(const Shape& shape);

/// Whether the shape is watertight and consistently oriented: every edge is traversed equally often both ways. Then any
/// ray from outside crosses the surface inwards as often as outwards, however parts overlap.
bool is_watertight_and_oriented(const Shape& shape);

}  // namespace shapegauge
