// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
#include <memory>
#include <string_view>

#include "shapegauge/core/base/words.h"
#include "shapegauge/core/fields/laplacian.h"
#include "shapegauge/core/proxy/proxy_geodesics.h"
#include "shapegauge/core/proxy/surface_proxy.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Surface on which a field or descriptor is computed: the shape's own mesh, or its surface proxy (ProxySource).
enum class FieldSurface { mesh, proxy };

template <>
inline constexpr std::array<std::string_view, 2> words_of<FieldSurface>{"mesh", "proxy"};

/// Surface proxy of a shape and data computed on it, each once on first use. Keeps a reference to the shape. Not
/// thread-safe. Accessors throw as the underlying computations do.
class ProxySource {
 public:
  /// Number of landmark points of the proxy from which geodesics() computes distances.
  static constexpr int landmarks = 500;
  /// Minimum number of eigenvalues that spectrum() computes, to share them between requests.
  static constexpr int shared_eigenvalues = 40;

  explicit ProxySource(const Shape& shape) : shape_(&shape) {}

  [[nodiscard]] const Shape& shape() const { return *shape_; }

  /// Returns the surface proxy of the shape.
  const SurfaceProxy& proxy();

  /// Returns the geodesic distances from the proxy's landmarks to its points.
  const ProxyGeodesics& geodesics();

  /// Returns the `eigenvalues` smallest eigenvalues of the proxy's Laplacian, with eigenvectors at the proxy's points;
  /// fewer if there are fewer points. One computation serves all requests for up to shared_eigenvalues.
  Spectrum spectrum(int eigenvalues);

  /// Interpolates one value per point of the proxy to samples of the shape: means over the 7 nearest points, weighted
  /// by distance and by the absolute cosine between the normals of point and sample.
  Eigen::VectorXd interpolate_to_samples(const Samples& samples, const Eigen::VectorXd& at_points);

 private:
  const Shape* shape_;
  std::unique_ptr<SurfaceProxy> proxy_;
  std::unique_ptr<ProxyGeodesics> geodesics_;
  std::map<int, Spectrum> spectra_;  ///< spectra by computed number of eigenvalues
};

}  // namespace shapegauge
