#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// For every vertex the vertices that share a triangle's edge with it, each once, in ascending order. Vertices at the
/// same place are one: they have the same neighbours, and of neighbours at the same place the first stands for all.
struct VertexNeighbours {
  std::vector<std::size_t> first;        ///< by vertex, where its neighbours begin; one more entry at the end
  std::vector<std::int32_t> neighbours;  ///< all, vertex by vertex

  [[nodiscard]] std::span<const std::int32_t> of(Eigen::Index vertex) const {
    const auto v = static_cast<std::size_t>(vertex);
    return std::span(neighbours).subspan(first[v], first[v + 1] - first[v]);
  }
};

/// The neighbours of a shape's vertices. None where there are no triangles. Throws InputError where the shape is
/// unusable (validity.h).
VertexNeighbours vertex_neighbours(const Shape& shape);

}  // namespace shapegauge
