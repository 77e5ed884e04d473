#pragma once

#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// A side of a triangle, and the edge that it lies on: two places of vertices, named by merged_by_place.
struct EdgeUse {
  std::int32_t low;       ///< the edge's lesser vertex
  std::int32_t high;      ///< the edge's greater vertex
  std::int32_t triangle;  ///< of which it is a side
  std::int8_t corner;     ///< at which the side begins; it leads to the next one
  bool forward;           ///< whether it leads from the lesser vertex to the greater

  [[nodiscard]] bool same_edge(const EdgeUse& other) const { return low == other.low && high == other.high; }
};

/// All sides of the triangles whose corners are at three places, sorted by edge, those of an edge by triangle.
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

}  // namespace shapegauge
