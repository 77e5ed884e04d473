#pragma once

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/experiments/generator/implicit_surface.h"

namespace shapegauge {

/// Meshes an implicit surface by restricted Delaunay refinement (CGAL's surface mesher; Boissonnat and Oudot 2005). The
/// triangles are close to equilateral; where the surface is thin they are smaller, as the square root of its thickness.
/// `coarseness` is the triangles' circumradius where the thickness is that of the ball around the surface, relative to
/// the ball's radius. The mesh is closed, manifold, of one component and oriented outward: where the refinement at that
/// coarseness does not give such a mesh, finer ones are tried. Throws std::runtime_error where none of them does.
Shape mesh_implicit_surface(const ImplicitSurface& surface, double coarseness);

/// The coarseness at which mesh_implicit_surface gives about so many triangles, by trial on this surface.
double coarseness_for(const ImplicitSurface& surface, int faces);

}  // namespace shapegauge
