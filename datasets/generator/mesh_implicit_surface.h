#pragma once

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/datasets/generator/implicit_surface.h"

namespace shapegauge {

/// Meshes an implicit surface with about so many triangles (within a fifth) by restricted Delaunay refinement (CGAL's
/// surface mesher; Boissonnat and Oudot 2005). The triangles are close to equilateral, no angle below 30 degrees; where
/// the surface is thin they are smaller, as the square root of its thickness. The mesh is closed, manifold, of one
/// component and oriented outward: where so few triangles do not give such a mesh, it has more. Throws
/// std::runtime_error where that does not help either.
Shape mesh_implicit_surface(const ImplicitSurface& surface, int faces);

/// Whether two triangles of a manifold mesh meet elsewhere than at a vertex or an edge that they share (CGAL, exact).
bool self_intersects(const Shape& mesh);

}  // namespace shapegauge
