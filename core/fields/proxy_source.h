#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>

#include "shapegauge/core/fields/laplacian.h"
#include "shapegauge/core/proxy/proxy_geodesics.h"
#include "shapegauge/core/proxy/surface_proxy.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// The surface proxy of a shape and what is computed on it, each when it is first asked for and once. Keeps a reference
/// to the shape. Not for several threads at a time. Functions throw what computing throws.
class ProxySource {
 public:
  /// Landmarks of geodesics().
  static constexpr int landmarks = 500;
  /// Eigenvalues that spectrum() computes at least.
  static constexpr int shared_eigenvalues = 40;

  explicit ProxySource(const Shape& shape) : shape_(&shape) {}

  [[nodiscard]] const Shape& shape() const { return *shape_; }

  const SurfaceProxy& proxy();

  const ProxyGeodesics& geodesics();

  /// The smallest eigenvalues of the proxy's Laplacian, with eigenvectors at the proxy's points; fewer where there are
  /// fewer points. All numbers up to shared_eigenvalues are answered from one computation.
  Spectrum spectrum(int eigenvalues);

  /// Values at the proxy's points interpolated to samples of the shape: means over the nearest points of the same
  /// sheet, weighted by distance.
  Eigen::VectorXd at_samples(const Samples& samples, const Eigen::VectorXd& at_points);

 private:
  const Shape* shape_;
  std::unique_ptr<SurfaceProxy> proxy_;
  std::unique_ptr<ProxyGeodesics> geodesics_;
  std::map<int, Spectrum> spectra_;  ///< by number of eigenvalues
};

}  // namespace shapegauge
