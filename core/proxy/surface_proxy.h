// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Cache version of surface_proxy(); increment when a proxy, its Laplacian or its geodesics change.
inline constexpr int surface_proxy_version = 5;

/// Combines the cache version of a descriptor that may be computed on the proxy with that of the proxy into one number.
constexpr int version_on_proxy(int version) { return 1000 * version + surface_proxy_version; }

/// Edge from a point of the proxy to a neighbour.
struct ProxyArc {
  std::int32_t to;  ///< index of the neighbouring point
  float length;     ///< length of the edge, in the shape's units
};

/// Proxy of a surface of any kind: evenly spread points with areas, normals, adjacency and a Laplacian.
struct SurfaceProxy {
  Points points;            ///< positions in farthest-point order, in the shape's units
  Points normals;           ///< unit normals without orientation: the first non-zero component is positive
  Eigen::VectorXd areas;    ///< area of the surface that each point represents; lumped mass matrix of the Laplacian
  double covering_radius;   ///< maximum distance of a surface sample from the proxy's point that represents it
  std::int32_t components;  ///< number of connected components before further arcs linked them
  std::vector<std::size_t> first_arc;     ///< per point: index of its first arc in `arcs`; last entry: number of arcs
  std::vector<ProxyArc> arcs;             ///< arcs between neighbours, in both directions; they connect all points
  Eigen::SparseMatrix<double> stiffness;  ///< matrix of the Laplacian: symmetric, positive semidefinite, rows sum to 0

  [[nodiscard]] std::span<const ProxyArc> arcs_of(std::size_t point) const {
    return std::span(arcs).subspan(first_arc[point], first_arc[point + 1] - first_arc[point]);
  }
};

/// Computes the proxy of a mesh of any kind or of a point cloud. The result is the same, to the byte, for any order of
/// faces, vertices and corners, any orientation of faces, and any number of threads.
///
/// Points are chosen from dense_samples() by farthest_points(). Neighbours are at most 2.5 covering radii apart and lie
/// on the same sheet according to their normals and the direction between them; the two sides of a thin wall are not
/// neighbours. The Laplacian is the mean of local ones: each point's neighbours, in its tangent plane at their
/// distances, have a planar Delaunay triangulation whose triangles count a third each (after Belkin, Sun, Wang 2009).
/// The nearest components are linked, which makes every distance finite.
///
/// There are fewer points than requested if the shape has fewer distinct positions. docs/methods/surface_proxy.md has
/// the measurements behind the default. Throws InputError as dense_samples() does.
SurfaceProxy surface_proxy(const Shape& shape, Eigen::Index points = 2000);

}  // namespace shapegauge
