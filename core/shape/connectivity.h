// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Values sorted by integer key, in stable order.
template <typename Value>
struct BucketSorted {
  std::vector<Value> values;       ///< values in ascending order of their keys
  std::vector<std::size_t> first;  ///< per key: index of its first value in `values`; last entry: number of values
};

/// Sorts values stably by integer keys in [0, keys), in linear time. key(value) returns the key of a value.
template <typename Value, typename Key>
BucketSorted<Value> bucket_sort(const std::vector<Value>& values, std::size_t keys, Key key) {
  BucketSorted<Value> result{std::vector<Value>(values.size()), std::vector<std::size_t>(keys + 1, 0)};
  for (const Value& value : values) ++result.first[static_cast<std::size_t>(key(value)) + 1];
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
  std::vector<std::size_t> next = result.first;
  for (const Value& value : values) result.values[next[static_cast<std::size_t>(key(value))]++] = value;
  return result;
}

/// Union-find over the integers from 0 to size() - 1.
class DisjointSets {
 public:
  [[nodiscard]] std::size_t size() const { return parent_.size(); }

  /// Adds the integers up to `size` - 1, each as a singleton set.
  void grow_to(std::size_t size) {
    while (parent_.size() < size) parent_.push_back(static_cast<std::int32_t>(parent_.size()));
  }

  /// Returns the smallest integer in the set that contains i.
  std::int32_t find(std::int32_t i) {
    while (parent(i) != i) i = parent(i) = parent(parent(i));
    return i;
  }

  /// Merges the sets of i and j.
  void join(std::int32_t i, std::int32_t j) {
    i = find(i);
    j = find(j);
    if (i != j) parent(std::max(i, j)) = std::min(i, j);
  }

 private:
  std::int32_t& parent(std::int32_t i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<std::int32_t> parent_;
};

/// Returns, for each vertex, the index of the first vertex at exactly the same position.
std::vector<std::int32_t> welded_vertices(const Points& vertices);

/// Returns, for each triangle, the index of the first triangle with the same corners in any order: its own index unless
/// it is a duplicate. `merged` is welded_vertices(): coincident vertices are equal corners.
std::vector<std::int32_t> first_duplicates(const Triangles& triangles, std::span<const std::int32_t> merged);

/// Coincident vertices and duplicate triangles of a mesh, computed once for several functions (welding_of()).
struct Welding {
  std::vector<std::int32_t> vertices;   ///< per vertex: first vertex at the same position (welded_vertices())
  std::vector<std::int32_t> triangles;  ///< per triangle: first triangle with the same corners (first_duplicates())

  /// Returns false for a duplicate of an earlier triangle.
  [[nodiscard]] bool is_distinct(Eigen::Index triangle) const {
    return triangles[static_cast<std::size_t>(triangle)] == triangle;
  }
};

/// Computes the coincident vertices and duplicate triangles of a mesh.
Welding welding_of(const Shape& shape);

/// Half-edge: a side of a triangle and its undirected edge, with welded vertex indices (welded_vertices()).
struct HalfEdge {
  std::int32_t low;       ///< smaller vertex index of the edge
  std::int32_t high;      ///< greater vertex index of the edge
  std::int32_t triangle;  ///< index of the triangle that the side belongs to
  std::int8_t corner;     ///< corner (0 to 2) at which the side begins; the side leads to the next corner
  bool forward;           ///< true if the side leads from vertex `low` to vertex `high`

  /// Returns true if both half-edges have the same undirected edge.
  [[nodiscard]] bool same_edge(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

/// Returns the half-edges of all triangles with three distinct corners, sorted by edge and then by triangle. Of
/// duplicate triangles only the first has half-edges (first_duplicates()).
std::vector<HalfEdge> half_edges(const Triangles& triangles, const Welding& welding);

/// Returns the half-edges of all triangles with three distinct corners, sorted by edge and then by triangle; of
/// duplicate triangles only those of the first. `merged` is the welded_vertices() of the mesh.
std::vector<HalfEdge> half_edges(const Triangles& triangles, std::span<const std::int32_t> merged);

/// Returns the half_edges() that decide whether a surface is closed: those of all triangles or, if the surface is
/// closed only without its degenerate triangles (is_degenerate()), those of the non-degenerate triangles.
std::vector<HalfEdge> surface_half_edges(const Shape& shape, const Welding& welding);

/// Calls visit(std::span<const HalfEdge>) once per undirected edge, with all half-edges of the edge. `uses` are sorted
/// by edge, as by half_edges().
template <typename Visit>
void for_each_edge(std::span<const HalfEdge> uses, Visit visit) {
  for (std::size_t begin = 0; begin < uses.size();) {
    std::size_t end = begin + 1;
    while (end < uses.size() && uses[end].same_edge(uses[begin])) ++end;
    visit(uses.subspan(begin, end - begin));
    begin = end;
  }
}

/// Returns true if the shape is closed, so that ray parity separates inside from outside: every edge has an even number
/// of triangles. Coincident vertices are welded; triangles of zero area and duplicates are ignored. Independent of
/// orientation. False without triangles. Throws InputError for an unusable shape (require_usable()).
bool is_closed(const Shape& shape);

/// Returns true if the shape is closed (is_closed()) and the triangles traverse every edge equally often in both
/// directions. Any ray from outside then crosses the surface inwards as often as outwards, even if parts overlap.
bool is_closed_and_oriented(const Shape& shape);

}  // namespace shapegauge
