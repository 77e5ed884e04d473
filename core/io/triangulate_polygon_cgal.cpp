// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "shapegauge/core/io/triangulate_polygon.h"

namespace shapegauge {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;

enum class Side : std::int8_t { unknown, outside, inside };

struct VertexInfo {
  std::int32_t corner = -1;  ///< the first of the polygon's corners that are here
  std::int32_t corners = 0;
};

using Structure = CGAL::Triangulation_data_structure_2<
    CGAL::Triangulation_vertex_base_with_info_2<VertexInfo, Kernel>,
    CGAL::Triangulation_face_base_with_info_2<Side, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;
using Vertex = Triangulation::Vertex_handle;
using Face = Triangulation::Face_handle;

/// Returns the key of an undirected edge.
std::uint64_t edge_key(Vertex a, Vertex b) {
  const auto [low, high] = std::minmax(a->info().corner, b->info().corner);
  return (static_cast<std::uint64_t>(low) << 32U) | static_cast<std::uint32_t>(high);
}

class PolygonTriangulator {
 public:
  explicit PolygonTriangulator(std::span<const Eigen::Vector2d> corners) {
    for (const Eigen::Vector2d& corner : corners) points_.emplace_back(corner.x(), corner.y());
  }

  std::vector<PolygonTriangle> triangles() {
    insert_corners();
    insert_edges();
    if (triangulation_.dimension() < 2) return {};
    mark_faces();
    std::vector<PolygonTriangle> found;
    for (const Face face : triangulation_.finite_face_handles()) {
      if (face->info() != Side::inside) continue;
      found.push_back({face->vertex(0)->info().corner, face->vertex(1)->info().corner, face->vertex(2)->info().corner});
    }
    return found;
  }

 private:
  /// Inserts the corners; coincident corners become one vertex.
  void insert_corners() {
    std::vector<std::size_t> order(points_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    using Traits = CGAL::Spatial_sort_traits_adapter_2<Kernel, CGAL::Pointer_property_map<Point>::type>;
    CGAL::spatial_sort(order.begin(), order.end(), Traits(CGAL::make_property_map(points_)));
    vertices_.resize(points_.size());
    Face near;
    for (const std::size_t i : order) {
      vertices_[i] = triangulation_.insert(points_[i], near);
      near = vertices_[i]->face();
    }
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      VertexInfo& info = vertices_[i]->info();
      if (info.corners++ == 0) info.corner = static_cast<std::int32_t>(i);
    }
  }

  void insert_edges() {
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      Vertex a = vertices_[i];
      Vertex b = vertices_[(i + 1) % vertices_.size()];
      if (a == b) continue;
      // CGAL walks around the first of the two; it should be the one with fewer corners.
      if (a->info().corners > b->info().corners) std::swap(a, b);
      triangulation_.insert_constraint(a, b);
      edges_.emplace_back(a, b);
    }
    for (const auto& [a, b] : edges_) count_uses(a, b);
  }

  /// Counts the use of each edge between a and b; there are several if corners lie on the polygon's edge.
  void count_uses(Vertex a, Vertex b) {
    while (a != b) {
      const Vertex next = triangulation_.is_edge(a, b) ? b : next_on_edge(a, b);
      ++uses_[edge_key(a, next)];
      a = next;
    }
  }

  Vertex next_on_edge(Vertex a, Vertex b) {
    Triangulation::Vertex_circulator neighbour = triangulation_.incident_vertices(a);
    while (triangulation_.is_infinite(neighbour) ||
           !CGAL::are_ordered_along_line(a->point(), neighbour->point(), b->point())) {
      ++neighbour;
    }
    return neighbour;
  }

  /// Marks the faces that an odd number of the polygon's edges separates from the outside.
  void mark_faces() {
    for (const Face face : triangulation_.all_face_handles()) face->info() = Side::unknown;
    std::vector<Face> reached = {triangulation_.infinite_face()};
    reached.front()->info() = Side::outside;
    while (!reached.empty()) {
      const Face face = reached.back();
      reached.pop_back();
      for (int k = 0; k < 3; ++k) {
        const Face other = face->neighbor(k);
        if (other->info() != Side::unknown) continue;
        const bool crosses = is_border(face, k);
        other->info() = crosses == (face->info() == Side::outside) ? Side::inside : Side::outside;
        reached.push_back(other);
      }
    }
  }

  [[nodiscard]] bool is_border(Face face, int k) const {
    if (!face->is_constrained(k)) return false;
    const auto found = uses_.find(edge_key(face->vertex(Triangulation::cw(k)), face->vertex(Triangulation::ccw(k))));
    return found != uses_.end() && found->second % 2 == 1;
  }

  std::vector<Point> points_;
  Triangulation triangulation_;
  std::vector<Vertex> vertices_;  ///< by corner
  std::vector<std::pair<Vertex, Vertex>> edges_;
  std::unordered_map<std::uint64_t, int> uses_;  ///< by edge_key()
};

}  // namespace

std::vector<PolygonTriangle> constrained_delaunay(std::span<const Eigen::Vector2d> corners) {
  try {
    return PolygonTriangulator(corners).triangles();
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return {};
  }
}

}  // namespace shapegauge
