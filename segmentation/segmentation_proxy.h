// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Shape that is segmented instead of another one, with the mapping between the two.
struct SegmentationProxy {
  Shape shape;
  std::vector<std::int32_t> node_of;  ///< by triangle (or point) of the given shape: its node of the proxy

  /// Transfers the proxy's labels to the given shape.
  [[nodiscard]] std::vector<std::int32_t> transfer(std::span<const std::int32_t> labels) const;
};

/// Chooses the shape to segment instead of a given one.
/// - For a mesh of few triangles: the same surface subdivided to at least 8,000 triangles, since patches consist of
///   triangles.
/// - For a mesh with more than one in twenty edges on a boundary: 10,000 points of its surface. A surface with cracks
///   everywhere has no usable adjacency and lets rays through; a point cloud has neither problem.
///
/// Other meshes and clouds are returned unchanged. Deterministic.
SegmentationProxy segmentation_proxy(const Shape& shape);

}  // namespace shapegauge
