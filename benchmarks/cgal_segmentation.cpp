// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/cgal_segmentation.h"

// clang-format off: before CGAL, which would include it inside of a namespace
#include <maxflow.h>
// clang-format on

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/mesh_segmentation.h>
#include <cstddef>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

Mesh cgal_mesh(const Shape& shape) {
  Mesh mesh;
  for (Eigen::Index v = 0; v < shape.vertices.rows(); ++v) {
    mesh.add_vertex({shape.vertices(v, 0), shape.vertices(v, 1), shape.vertices(v, 2)});
  }
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const auto corner = [&](int k) { return Mesh::Vertex_index(static_cast<unsigned>(shape.triangles(f, k))); };
    if (mesh.add_face(corner(0), corner(1), corner(2)) == Mesh::null_face()) {
      throw InputError("CGAL cannot hold the mesh: it is not a manifold");
    }
  }
  return mesh;
}

}  // namespace

std::vector<std::int32_t> cgal_segmentation(const Shape& shape, int clusters, double smoothing) {
  Mesh mesh = cgal_mesh(shape);
  const auto sdf = mesh.add_property_map<Mesh::Face_index, double>("f:sdf").first;
  const auto segments = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  CGAL::sdf_values(mesh, sdf);
  CGAL::segmentation_from_sdf_values(mesh, sdf, segments, static_cast<std::size_t>(clusters), smoothing);
  std::vector<std::int32_t> labels;
  for (const Mesh::Face_index face : mesh.faces()) labels.push_back(static_cast<std::int32_t>(segments[face]));
  return labels;
}

}  // namespace shapegauge
