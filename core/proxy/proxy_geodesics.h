#pragma once

#include <Eigen/Core>

#include "shapegauge/core/proxy/surface_proxy.h"

namespace shapegauge {

/// Geodesic distances from landmarks of a proxy.
struct ProxyGeodesics {
  Eigen::MatrixXf distances;  ///< a row a point of the proxy, a column a landmark; in the shape's units
  Eigen::VectorXd areas;      ///< of the surface that is geodesically nearest to each landmark
};

/// Distances along the arcs of the proxy from its first `landmarks` points (all, where there are fewer), which are its
/// farthest points. Shortest paths of the graph: a few percent longer than geodesics.
ProxyGeodesics proxy_geodesics(const SurfaceProxy& proxy, Eigen::Index landmarks);

}  // namespace shapegauge
