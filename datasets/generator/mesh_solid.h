#pragma once

#include <Eigen/Core>
#include <optional>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/datasets/generator/solid.h"

namespace shapegauge {

/// An object's mesh.
struct SolidMesh {
  Shape mesh;
  Eigen::VectorXi labels;  ///< for each triangle, the label of its part
};

/// Meshes an object with about so many triangles (within a fifth): marching tetrahedra (Doi and Koide 1991) on a grid
/// fine enough for the thinnest wall, then isotropic remeshing (CGAL; Botsch and Kobbelt 2004). The mesh is closed,
/// manifold, of one component, oriented outward and free of self-intersections; where walls are thin it has more
/// triangles. Nothing where no such mesh is found: the object is in pieces, or its walls are too thin.
std::optional<SolidMesh> mesh_solid(const SolidObject& object, int faces);

}  // namespace shapegauge
