#pragma once

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Makes a surface of a point cloud: a square at each point, across its normal, of four times the area that the point
/// stands for (point_weights()), so that squares of points spread at random cover 98 % of a smooth surface. The normals
/// are those of the cloud or, where it has none, unsigned_point_normals(). Areas are equal multiples of the points', so
/// that means over the squares are means over the surface. Points without area or normal have no square. A mesh is
/// returned without its doubled triangles. Throws InputError for an unusable shape (require_usable()).
Shape splatted(const Shape& shape);

}  // namespace shapegauge
