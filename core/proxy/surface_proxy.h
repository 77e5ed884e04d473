#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/core/base/parameter.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Cache version; increment when a proxy, its Laplacian or its geodesics change.
inline constexpr int surface_proxy_version = 3;

/// The version of a descriptor that may be computed on the proxy: its own and the proxy's.
constexpr int version_on_proxy(int version) { return 1000 * version + surface_proxy_version; }

/// Settings of surface_proxy(). docs/methods/surface_proxy.md has the measurements behind the defaults.
struct SurfaceProxyOptions {
  static constexpr Bounds points_bounds{.low = 2, .high = 100'000};
  static constexpr Bounds neighbours_bounds{.low = 6, .high = 64};

  int points = 2000;           ///< of the proxy; a shape with fewer places has fewer
  int samples_per_point = 12;  ///< dense samples that each point is chosen from and stands for
  int neighbours = 20;         ///< nearest points among which a point has its neighbours
};

/// A neighbour of a proxy's point.
struct ProxyArc {
  std::int32_t to;
  float length;
};

/// A stand-in for a surface of any kind: evenly spread points with areas and normals, the neighbours of each, and a
/// Laplacian.
struct SurfaceProxy {
  Points points;            ///< in farthest-point order, in the shape's units
  Points normals;           ///< unit vectors; the first component that is not 0 is positive
  Eigen::VectorXd areas;    ///< of the surface nearest to each point; the lumped mass of the Laplacian
  double covering_radius;   ///< the largest distance of a place of the surface from the point that stands for it
  std::int32_t components;  ///< number of pieces before they were linked
  std::vector<std::size_t> first_arc;     ///< by point, where its arcs begin; one more entry at the end
  std::vector<ProxyArc> arcs;             ///< each neighbourhood twice, once from either end; one component
  Eigen::SparseMatrix<double> stiffness;  ///< symmetric, not negative definite, rows sum to 0

  [[nodiscard]] std::span<const ProxyArc> arcs_of(std::size_t point) const {
    return std::span(arcs).subspan(first_arc[point], first_arc[point + 1] - first_arc[point]);
  }
};

/// Makes the proxy of a mesh of any kind or of a point cloud; the same bytes for any order of faces, vertices and
/// corners, any orientation of faces, and any number of threads.
///
/// Points are chosen from dense_samples() by farthest_points(). Neighbours are at most 2.5 covering radii apart and lie
/// on the same sheet as far as their normals and the direction between them say: the two sides of a thin wall are no
/// neighbours. The Laplacian is the mean of local ones: each point's neighbours in its tangent plane, at their
/// distances, have a planar Delaunay triangulation, of whose triangles each counts a third (after Belkin, Sun, Wang
/// 2009). Components are linked where they are nearest, so that every distance is finite.
///
/// Throws InputError for options out of bounds and as dense_samples().
SurfaceProxy surface_proxy(const Shape& shape, const SurfaceProxyOptions& options = {});

}  // namespace shapegauge
