// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Converts a CGAL::Surface_mesh of triangles without removed elements to a shape with the same vertices and triangles.
template <typename SurfaceMesh>
Shape shape_of_mesh(const SurfaceMesh& mesh) {
  Shape shape;
  shape.vertices.resize(static_cast<Eigen::Index>(mesh.number_of_vertices()), 3);
  shape.triangles.resize(static_cast<Eigen::Index>(mesh.number_of_faces()), 3);
  for (const auto v : mesh.vertices()) {
    const auto& point = mesh.point(v);
    shape.vertices.row(static_cast<Eigen::Index>(v.idx())) << point.x(), point.y(), point.z();
  }
  for (const auto f : mesh.faces()) {
    int k = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) {
      shape.triangles(static_cast<Eigen::Index>(f.idx()), k++) = static_cast<std::int32_t>(v.idx());
    }
  }
  return shape;
}

}  // namespace shapegauge
