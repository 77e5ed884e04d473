// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Mesh to segment, without the triangles that receive the labels of others: duplicates (distinct_triangles()), and
/// triangles with coincident corners, which have no area and no neighbours.
struct SoundMesh {
  Shape shape;  ///< mesh to segment, or the unchanged point cloud
  /// Per triangle of the original mesh, an index in `shape`: of the triangle itself, of its first duplicate or, for
  /// coincident corners, of the closest triangle. Empty for a cloud.
  std::vector<std::int32_t> triangle_of;

  /// Extends labels of `shape` to all triangles of the original mesh: returns one label per triangle. Returns labels of
  /// a cloud unchanged.
  [[nodiscard]] std::vector<std::int32_t> extended(std::vector<std::int32_t> labels) const;
};

/// Removes duplicate triangles and triangles with coincident corners from a mesh; a cloud stays unchanged. Throws
/// InputError for an unusable shape (require_usable()), and if no triangle is left.
SoundMesh sound_mesh(const Shape& shape);

}  // namespace shapegauge
