// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Number of triangles of a splat, the hexagon that represents a point of a cloud.
constexpr int triangles_per_splat = 4;

/// Makes a mesh that represents the surface of a point cloud: a hexagon in the tangent plane of each point. The
/// hexagons overlap for randomly spread points. Triangle f belongs to point f / triangles_per_splat. The plane follows
/// from the point's normal or, without one, from unsigned_point_normals(). Hexagons have a size of 0 if all
/// points coincide. Throws as point_weights() does.
Shape splats(const Shape& cloud);

}  // namespace shapegauge
