#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <string_view>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// How lengths of shortest paths on a surface are found.
enum class GeodesicMethod {
  graph,  ///< Dijkstra's algorithm; takes every shape. A few percent too long
  heat,   ///< the heat method (Crane, Weischedel, Wardetzky 2013), CGAL's; connected manifold meshes only
  exact,  ///< exact on the mesh (Xin and Wang 2009), CGAL's; connected manifold meshes only, slow
};

template <>
inline constexpr std::array<std::string_view, 3> words_of<GeodesicMethod>{"graph", "heat", "exact"};

/// Settings of geodesic distances.
struct GeodesicOptions {
  GeodesicMethod method = GeodesicMethod::graph;
  int neighbours = 8;  ///< nearest points joined in a point cloud, and across the gaps between components
};

/// What may be chosen of GeodesicOptions.
inline constexpr std::array geodesic_table = {
    option_of<&GeodesicOptions::method>("method",
                                        "graph: shortest paths, on every shape, a few percent too long; heat and "
                                        "exact: CGAL's, on connected manifold meshes."),
    option_of<&GeodesicOptions::neighbours>(
        "neighbours", {.low = 1, .high = 64},
        "Nearest points that are joined in a point cloud, and across the gaps between components."),
};

/// The distances from one vertex to all vertices, in the shape's units. NaN at vertices that no triangle uses.
using GeodesicDistances = std::function<Eigen::VectorXd(std::int32_t source)>;

/// Geodesic distances on a shape, prepared once for any number of sources. The function does not refer to the shape; it
/// may be called from several threads with `graph`, from one at a time with the other methods.
///
/// `graph` joins the vertices along the edges, and across each edge with two triangles along the straight segment in
/// the two triangles' unfolded plane, where it crosses the edge. Vertices at the same place are one, doubled triangles
/// count once. A point cloud's points are joined to their nearest neighbours. Where the graph has several components
/// they are joined, so that every distance is finite: vertices of different components that are among each other's
/// nearest neighbours first, then each remaining component with the nearest of the others (nearest among 64 vertices of
/// each).
///
/// Throws InputError for options out of range, an unusable shape (require_usable()), a shape without vertices, and,
/// with `heat` and `exact`, for what is not one connected manifold mesh.
GeodesicDistances geodesic_distances(const Shape& shape, const GeodesicOptions& options = {});

}  // namespace shapegauge
