// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/fields/geodesics_cgal.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <cstddef>
#include <fmt/format.h>
#include <limits>
#include <memory>
#include <vector>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Heat = CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh, CGAL::Heat_method_3::Intrinsic_Delaunay>;
using Exact = CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;

constexpr std::int32_t unused = -1;

/// Used vertices of a shape as a mesh.
struct ConnectedMesh {
  Mesh mesh;
  std::vector<std::int32_t> mesh_vertex;  ///< of each of the shape's vertices, or `unused`

  [[nodiscard]] Mesh::Vertex_index at(std::int32_t vertex) const {
    return Mesh::Vertex_index(static_cast<Mesh::size_type>(mesh_vertex[static_cast<std::size_t>(vertex)]));
  }
};

InputError unsuitable(const std::string& why) {
  return InputError(
      fmt::format("{}: the geodesic methods heat and exact need a connected, consistently oriented manifold mesh; use "
                  "the method graph",
                  why));
}

std::shared_ptr<ConnectedMesh> connected_mesh(const Shape& shape) {
  if (is_cloud(shape)) throw unsuitable("the shape has no triangles");
  auto result = std::make_shared<ConnectedMesh>();
  result->mesh_vertex.assign(static_cast<std::size_t>(shape.vertices.rows()), unused);
  const auto vertex_of = [&](std::int32_t v) {
    std::int32_t& known = result->mesh_vertex[static_cast<std::size_t>(v)];
    if (known == unused) {
      known = static_cast<std::int32_t>(
          result->mesh.add_vertex({shape.vertices(v, 0), shape.vertices(v, 1), shape.vertices(v, 2)}).idx());
    }
    return result->at(v);
  };
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    const Mesh::Vertex_index a = vertex_of(shape.triangles(f, 0));
    const Mesh::Vertex_index b = vertex_of(shape.triangles(f, 1));
    const Mesh::Vertex_index c = vertex_of(shape.triangles(f, 2));
    if (a == b || b == c || c == a || result->mesh.add_face(a, b, c) == Mesh::null_face()) {
      throw unsuitable(
          fmt::format("triangle {} (counted from 0) has a corner twice, or meets others in a non-manifold "
                      "or inconsistently oriented edge or vertex",
                      f));
    }
  }
  auto component = result->mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component", 0).first;
  const std::size_t components = CGAL::Polygon_mesh_processing::connected_components(result->mesh, component);
  if (components != 1) throw unsuitable(fmt::format("the mesh has {} components", components));
  return result;
}

template <typename DistanceAt>
Eigen::VectorXd of_all_vertices(const ConnectedMesh& connected, DistanceAt distance_at) {
  Eigen::VectorXd distances = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(connected.mesh_vertex.size()),
                                                        std::numeric_limits<double>::quiet_NaN());
  for (std::size_t v = 0; v < connected.mesh_vertex.size(); ++v) {
    if (connected.mesh_vertex[v] == unused) continue;
    distances[static_cast<Eigen::Index>(v)] = distance_at(connected.at(static_cast<std::int32_t>(v)));
  }
  return distances;
}

GeodesicDistances by_heat(const std::shared_ptr<ConnectedMesh>& connected) {
  const auto heat = std::make_shared<Heat>(connected->mesh);
  return [connected, heat](std::int32_t source) {
    auto distance = connected->mesh.add_property_map<Mesh::Vertex_index, double>("v:distance", 0).first;
    heat->clear_sources();
    heat->add_source(connected->at(source));
    heat->estimate_geodesic_distances(distance);
    return of_all_vertices(*connected, [&](Mesh::Vertex_index v) { return distance[v]; });
  };
}

GeodesicDistances exactly(const std::shared_ptr<ConnectedMesh>& connected) {
  return [connected](std::int32_t source) {
    Exact exact(connected->mesh);
    exact.add_source_point(connected->at(source));
    return of_all_vertices(*connected,
                           [&](Mesh::Vertex_index v) { return exact.shortest_distance_to_source_points(v).first; });
  };
}

}  // namespace

GeodesicDistances geodesic_distances_cgal(const Shape& shape, GeodesicMethod method) {
  const std::shared_ptr<ConnectedMesh> connected = connected_mesh(shape);
  return method == GeodesicMethod::heat ? by_heat(connected) : exactly(connected);
}

}  // namespace shapegauge
