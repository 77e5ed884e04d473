// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/datasets/generator/solid.h"

namespace shapegauge {

/// Mesh of a rigid object with a part label per triangle.
struct SolidMesh {
  Shape mesh;              ///< surface of the object
  Eigen::VectorXi labels;  ///< part label of each triangle (SolidPart::label)
};

/// Meshes an object with about `faces` triangles (within a fifth): marching tetrahedra (Doi and Koide 1991) on a grid
/// fine enough for the thinnest wall, followed by isotropic remeshing (CGAL; Botsch and Kobbelt 2004). The mesh is
/// closed, manifold, connected, oriented outwards and free of self-intersections; thin walls increase the number of
/// triangles. Returns nothing if the object is not connected or its walls are too thin.
std::optional<SolidMesh> mesh_solid(const SolidObject& object, int faces);

}  // namespace shapegauge
