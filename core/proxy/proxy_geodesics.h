// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "shapegauge/core/proxy/surface_proxy.h"

namespace shapegauge {

/// Geodesic distances from landmarks of a proxy.
struct ProxyGeodesics {
  Eigen::MatrixXf distances;  ///< one row per point of the proxy, one column per landmark; in the shape's units
  Eigen::VectorXd areas;      ///< area of each landmark's geodesic Voronoi cell, in the shape's units squared
};

/// Computes distances along the arcs of the proxy from its first `landmarks` points (all, if there are fewer), which
/// are in farthest-point order. Shortest paths of the graph are a few percent longer than geodesics.
ProxyGeodesics proxy_geodesics(const SurfaceProxy& proxy, Eigen::Index landmarks);

}  // namespace shapegauge
