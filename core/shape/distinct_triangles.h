// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Mesh without its duplicate triangles: triangles with the same three corners in any order, with coincident vertices
/// welded. The first in the order of the shape is kept (docs/reference/definitions.md#doubled-triangles).
struct DistinctTriangles {
  Shape shape;  ///< all vertices of the mesh, and its triangles without duplicates
  std::vector<std::int32_t>
      triangle_of;  ///< per triangle of the mesh: index in `shape` of the first triangle with the same corners
  /// Per vertex of the mesh: its own index or, if only removed duplicates use it, the index of the coincident corner of
  /// the remaining triangle.
  std::vector<std::int32_t> vertex_of;

  /// Returns true if the mesh had duplicate triangles, which were removed.
  [[nodiscard]] bool has_duplicates() const { return shape.triangles.rows() < std::ssize(triangle_of); }
};

/// Removes the duplicate triangles of a usable mesh. Returns the remaining mesh and the maps of indices to it. A cloud
/// stays unchanged.
DistinctTriangles distinct_triangles(Shape shape);

/// Returns the mesh without its duplicate triangles.
Shape without_duplicates(Shape shape);

}  // namespace shapegauge
