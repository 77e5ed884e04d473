// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/datasets/generator/implicit_surface.h"

namespace shapegauge {

/// Meshes an implicit surface with about `faces` triangles (within a fifth) by restricted Delaunay refinement (CGAL's
/// surface mesher; Boissonnat and Oudot 2005). Triangles are nearly equilateral, with no angle below 30 degrees; on
/// thin parts they shrink with the square root of the thickness. The mesh is closed, manifold, connected and oriented
/// outwards; it has more triangles if that is necessary. Throws std::runtime_error if meshing fails.
Shape mesh_implicit_surface(const ImplicitSurface& surface, int faces);

/// Returns true if two triangles of a manifold mesh intersect other than at a shared vertex or edge (CGAL, exact).
bool self_intersects(const Shape& mesh);

}  // namespace shapegauge
