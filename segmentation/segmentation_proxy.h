// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Shape that is segmented in place of an original shape, with the mapping from the original to the proxy.
struct SegmentationProxy {
  Shape shape;                        ///< proxy: mesh or point cloud to segment
  std::vector<std::int32_t> node_of;  ///< per triangle or point of the original: index of its node in the proxy

  /// Transfers labels from the proxy to the original: returns one label per triangle or point of the original.
  [[nodiscard]] std::vector<std::int32_t> transfer(std::span<const std::int32_t> labels) const;
};

/// Makes the shape to segment in place of `shape`.
/// - For a mesh of less than 8,000 triangles: the same surface subdivided to at least 8,000 triangles, since patches
///   consist of triangles.
/// - For a mesh with more than one in twenty edges on a boundary: 10,000 points of its surface. A surface with cracks
///   everywhere has no usable adjacency and lets rays through; a point cloud has neither problem.
///
/// Other meshes and clouds are returned unchanged. Deterministic.
SegmentationProxy segmentation_proxy(const Shape& shape);

}  // namespace shapegauge
