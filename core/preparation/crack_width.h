#pragma once

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/core/spatial/triangle_bvh.h"

namespace shapegauge {

/// Computes half the width of the widest crack of a mesh that is narrower than `widest`: the largest half distance from
/// a boundary edge, across a crack, to the surface beyond. A crack is where a ball that touches the edge, in the plane
/// of its triangle, meets other parts of the surface. 0 if there is none. `tree` is that of the mesh, whose coordinates
/// are of the order of 1. Surfaces nearer than about 1e-6 of their triangles' size count as touching.
double half_crack_width(const Shape& mesh, const TriangleBVH& tree, double widest);

}  // namespace shapegauge
