// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Element shared by two adjacent triangles.
enum class SharedElement { edge, vertex };

/// Adjacency of the triangles of a mesh, for tests whether triangles are connected near a point. Empty for a cloud.
class LocalConnectivity {
 public:
  /// Builds the adjacency. `merged` and `uses` are welded_vertices() and half_edges() of the shape.
  LocalConnectivity(const Shape& shape, std::span<const std::int32_t> merged, std::span<const HalfEdge> uses);

  /// Returns true if two triangles are connected by a path across edges.
  [[nodiscard]] bool in_same_component(std::int32_t a, std::int32_t b) const {
    return component_[at(a)] == component_[at(b)];
  }

  /// Returns true if a path connects two triangles through triangles whose bounding spheres intersect a ball.
  /// Consecutive triangles share an edge or, if `shared` is vertex, a vertex; vertex needs a mesh with boundary edges.
  bool connected_in_ball(std::int32_t from, std::int32_t to, const Eigen::Vector3d& centre, double radius,
                         SharedElement shared = SharedElement::edge);

  /// Returns true if the last connected_in_ball() visited a triangle with a boundary edge.
  [[nodiscard]] bool has_visited_boundary() const { return has_visited_boundary_; }

 private:
  /// Adjacency of an element and a triangle. The element is a triangle in across_edges_, a welded vertex in fans_.
  struct Neighbour {
    std::int32_t of;        ///< index of the element: of a triangle or a welded vertex
    std::int32_t triangle;  ///< index of the triangle adjacent to the element
  };

  using Neighbours = BucketSorted<Neighbour>;  ///< adjacencies sorted by element

  static std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }
  /// Returns the triangles adjacent to the element with the index `key`: a triangle if `neighbours` is across_edges_, a
  /// welded vertex if it is fans_.
  static std::span<const Neighbour> of(const Neighbours& neighbours, std::int32_t key);
  void set_fans(const Shape& shape, std::span<const std::int32_t> merged);
  [[nodiscard]] bool visited(std::int32_t triangle) const { return visited_by_[at(triangle)] == search_; }
  [[nodiscard]] bool meets(std::int32_t triangle, const Eigen::Vector3d& centre, double radius) const {
    const double reach = radius + spheres_(3, triangle);
    return (spheres_.col(triangle).head<3>() - centre).squaredNorm() <= reach * reach;
  }
  void visit(std::int32_t triangle);
  template <typename Use>
  void for_each_neighbour(std::int32_t triangle, SharedElement shared, std::int32_t mark, Use use);
  void walk_towards(std::int32_t to, const Eigen::Vector3d& centre, double radius, SharedElement shared);

  Neighbours across_edges_;  ///< per triangle: triangles with a common edge
  Neighbours fans_;          ///< per welded vertex: its triangles; empty without boundary edges
  std::vector<std::array<std::int32_t, 3>> corners_;  ///< per triangle: welded vertices; empty without boundary edges
  std::vector<std::int32_t> fan_used_by_;  ///< per vertex: mark of the last traversal that used its triangles
  Eigen::Matrix4Xd spheres_;               ///< per triangle: centre and radius of its bounding sphere
  std::vector<char> on_border_;            ///< per triangle: 1 if it has a boundary edge
  std::vector<std::int32_t> component_;    ///< per triangle: index of its edge-connected component
  std::vector<std::int32_t> visited_by_;   ///< per triangle: number of the last search that visited it
  std::vector<std::int32_t> queue_;        ///< triangles in the order of visits
  std::int32_t search_ = 0;                ///< number of the last search, from 1 on
  bool has_visited_boundary_ = false;      ///< value of has_visited_boundary()
};

}  // namespace shapegauge
