// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/mesh_segmentation.h>
#include <fmt/format.h>
#include <limits>
#include <numbers>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/stopwatch.h"
#include "shapegauge/core/sdf/cone_sdf_engines.h"

namespace shapegauge {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using FaceValues = Mesh::Property_map<Mesh::Face_index, double>;
constexpr double no_answer = -1;  // CGAL's

/// The faces of the mesh are the shape's triangles, in their order.
Mesh mesh_of(const Shape& shape) {
  Mesh mesh;
  for (Eigen::Index v = 0; v < shape.vertices.rows(); ++v) {
    mesh.add_vertex({shape.vertices(v, 0), shape.vertices(v, 1), shape.vertices(v, 2)});
  }
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const Mesh::Vertex_index a(static_cast<Mesh::size_type>(shape.triangles(f, 0)));
    const Mesh::Vertex_index b(static_cast<Mesh::size_type>(shape.triangles(f, 1)));
    const Mesh::Vertex_index c(static_cast<Mesh::size_type>(shape.triangles(f, 2)));
    if (a == b || b == c || c == a || mesh.add_face(a, b, c) == Mesh::null_face()) {
      throw InputError(fmt::format(
          "triangle {} (counted from 0) has a repeated corner, a non-manifold edge or vertex, or the opposite "
          "orientation of a neighbour, which the cgal engine does not support; use the embree engine",
          f));
    }
  }
  return mesh;
}

/// Throws InputError for a mesh without area: its search tree would be empty, in which CGAL 5.5 crashes.
void require_area(const Mesh& mesh) {
  for (const Mesh::Face_index face : mesh.faces()) {
    const auto side = mesh.halfedge(face);
    if (!CGAL::collinear(mesh.point(mesh.source(side)), mesh.point(mesh.target(side)),
                         mesh.point(mesh.target(mesh.next(side))))) {
      return;
    }
  }
  throw InputError("the mesh has no area: all triangles are degenerate, and the cgal engine needs one that is not");
}

/// At least one face must have a value: CGAL fills the others from their neighbours or with the lowest.
void postprocess(const Mesh& mesh, const FaceValues& values) {
  const auto [lowest, highest] = CGAL::sdf_values_postprocessing(mesh, values);
  if (lowest < highest) return;
  // CGAL leaves values that are all equal as they are; scaled to [0, 1] they are the lowest.
  for (const Mesh::Face_index face : mesh.faces()) values[face] = 0;
}

}  // namespace

ConeSdfResult cone_sdf_cgal(const Shape& shape, const ConeSdfOptions& options) {
  const Stopwatch building;
  Mesh mesh = mesh_of(shape);
  require_area(mesh);
  const FaceValues values = mesh.add_property_map<Mesh::Face_index, double>("f:sdf", no_answer).first;
  ConeSdfResult result;
  result.build_seconds = building.seconds();

  const Stopwatch querying;
  const double angle = options.opening_angle_degrees / 180 * std::numbers::pi;
  const double highest =
      CGAL::sdf_values(mesh, values, angle, static_cast<std::size_t>(options.rays), /*postprocess=*/false).second;
  if (options.postprocess && highest >= 0) postprocess(mesh, values);
  result.values.resize(shape.triangles.rows());
  for (const Mesh::Face_index face : mesh.faces()) {
    const double value = values[face];
    result.values[static_cast<Eigen::Index>(face)] =
        value == no_answer ? std::numeric_limits<double>::quiet_NaN() : value;
  }
  result.query_seconds = querying.seconds();
  return result;
}

}  // namespace shapegauge
