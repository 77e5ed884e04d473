#pragma once

#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// A mesh without its doubled triangles. Doubles are triangles with the same three corners in any order, vertices at
/// the same place taken as one; the first of them, in the order of the shape, stands for all
/// (docs/reference/definitions.md#doubled-triangles).
struct DistinctTriangles {
  Shape shape;                            ///< all vertices of the mesh, and its triangles without the doubles
  std::vector<std::int32_t> triangle_of;  ///< by triangle of the mesh: its index, or that of its first, in `shape`
  /// By vertex: itself or, where only doubles use it, the vertex of their first at the same place.
  std::vector<std::int32_t> vertex_of;

  [[nodiscard]] bool has_doubles() const { return shape.triangles.rows() < std::ssize(triangle_of); }
};

/// Separates a mesh, which is usable, from its doubled triangles. A cloud stays as it is.
DistinctTriangles distinct_triangles(Shape shape);

/// Returns the mesh without its doubled triangles.
Shape without_doubles(Shape shape);

}  // namespace shapegauge
