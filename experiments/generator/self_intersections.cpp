#include "shapegauge/experiments/generator/self_intersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

namespace shapegauge {

bool self_intersects(const Shape& mesh) {
  using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
  using Vertex = Mesh::Vertex_index;
  Mesh halfedges;
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    halfedges.add_vertex({mesh.vertices(i, 0), mesh.vertices(i, 1), mesh.vertices(i, 2)});
  }
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    const auto corner = [&](int k) { return Vertex(static_cast<Mesh::size_type>(mesh.triangles(f, k))); };
    halfedges.add_face(corner(0), corner(1), corner(2));
  }
  return CGAL::Polygon_mesh_processing::does_self_intersect(halfedges);
}

}  // namespace shapegauge
