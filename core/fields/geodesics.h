// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <string_view>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Algorithm for geodesic distances.
enum class GeodesicMethod {
  graph,  ///< Dijkstra's algorithm, for any shape; overestimates by a few percent
  heat,   ///< heat method (Crane, Weischedel, Wardetzky 2013) of CGAL; connected manifold meshes only
  exact,  ///< exact on the mesh (Xin and Wang 2009), by CGAL; connected manifold meshes only, slow
};

template <>
inline constexpr std::array<std::string_view, 3> words_of<GeodesicMethod>{"graph", "heat", "exact"};

/// Options of geodesic_distances().
struct GeodesicOptions {
  GeodesicMethod method = GeodesicMethod::graph;  ///< algorithm
  int neighbours = 8;  ///< number of nearest points connected in a cloud, and across gaps between components
};

/// Names, bounds and help texts of the parameters in GeodesicOptions (option_parameters.h).
inline constexpr std::array geodesic_table = {
    option_of<&GeodesicOptions::method>("method",
                                        "Geodesic algorithm. graph: shortest paths, for any shape, a few percent too "
                                        "long; heat (heat method), exact (slow): for connected manifold meshes only."),
    option_of<&GeodesicOptions::neighbours>("neighbours", {.low = 1, .high = 64},
                                            "With method graph: number of nearest neighbours connected to each point "
                                            "of a cloud. Meshes use their edges, and "
                                            "connect only nearest neighbours in other components."),
};

/// Function that returns the distances from one vertex to all vertices, in the shape's units. NaN at vertices that no
/// triangle uses.
using GeodesicDistances = std::function<Eigen::VectorXd(std::int32_t source)>;

/// Prepares geodesic distances on a shape for any number of sources. The returned function does not refer to the shape.
/// It is thread-safe with `graph` only.
///
/// `graph` connects vertices along edges and, across each edge with two triangles, along the straight segment in the
/// unfolded plane of the triangles if it crosses the edge. Coincident vertices are welded, and duplicate triangles
/// count once. Points of a cloud are connected to their nearest neighbours. Further edges connect all components, so
/// that every distance is finite. First, every vertex is connected to those of its nearest neighbours that belong to
/// other components; then each component that is still separate is connected to the closest other one, found by up to
/// 64 vertices of each.
///
/// Throws InputError for options out of range, an unusable shape (require_usable()) and a shape without vertices. With
/// `heat` and `exact`, also throws for anything but a connected manifold mesh.
GeodesicDistances geodesic_distances(const Shape& shape, const GeodesicOptions& options = {});

}  // namespace shapegauge
