#pragma once

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// The number of triangles of a splat.
constexpr int triangles_per_splat = 4;

/// A mesh that looks like the surface a point cloud lies on: at each point a hexagon in the tangent plane, so large
/// that hexagons overlap where the points are spread at random; triangle f belongs to point f / triangles_per_splat.
/// The plane is that of the point's normal or, without one, of its 12 nearest neighbours. Of no size where all points
/// are at one place. Throws as point_weights().
Shape splats(const Shape& cloud);

}  // namespace shapegauge
