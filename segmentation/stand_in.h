#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// A shape that is cut in place of another one, and what its parts say of the other.
struct StandIn {
  Shape shape;
  std::vector<std::int32_t> node_of;  ///< by triangle (or point) of the given shape: one of the stand-in's

  /// The stand-in's labels, carried to the given shape.
  [[nodiscard]] std::vector<std::int32_t> carried_back(std::span<const std::int32_t> labels) const;
};

/// What to cut in place of a mesh:
/// - of few triangles: the same surface in at least 8,000 triangles, each cut into four as often as that takes. Patches
///   need triangles to be made of;
/// - of whose edges one in twenty has a single triangle: 10,000 points of its surface. A surface that is cracked
///   everywhere has no neighbours to walk to and lets rays through; a cloud's points see neither.
/// Any other mesh, and a cloud, stand for themselves. The same for the same shape.
StandIn stand_in(const Shape& shape);

}  // namespace shapegauge
