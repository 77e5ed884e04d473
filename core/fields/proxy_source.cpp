// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/fields/proxy_source.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "shapegauge/core/shape/point_cloud.h"

namespace shapegauge {

namespace {

Laplacian laplacian_of(const SurfaceProxy& proxy) {
  Laplacian laplacian{proxy.stiffness, proxy.areas,
                      std::vector<std::int32_t>(static_cast<std::size_t>(proxy.areas.size()))};
  std::iota(laplacian.node_of.begin(), laplacian.node_of.end(), 0);
  return laplacian;
}

}  // namespace

const SurfaceProxy& ProxySource::proxy() {
  if (!proxy_) proxy_ = std::make_unique<SurfaceProxy>(surface_proxy(*shape_));
  return *proxy_;
}

const ProxyGeodesics& ProxySource::geodesics() {
  if (!geodesics_) geodesics_ = std::make_unique<ProxyGeodesics>(proxy_geodesics(proxy(), landmarks));
  return *geodesics_;
}

Spectrum ProxySource::spectrum(int eigenvalues) {
  // A fixed number, not part of an earlier result: values must not depend on the order of calls.
  const int computed = std::max(eigenvalues, shared_eigenvalues);
  if (!spectra_.contains(computed)) spectra_.emplace(computed, laplacian_spectrum(laplacian_of(proxy()), computed));
  const Spectrum& all = spectra_.at(computed);
  const Eigen::Index count = std::min<Eigen::Index>(eigenvalues, all.eigenvalues.size());
  return {.eigenvalues = all.eigenvalues.head(count),
          .components = all.components,
          .eigenvectors = all.eigenvectors.leftCols(count)};
}

Eigen::VectorXd ProxySource::interpolate_to_samples(const Samples& samples, const Eigen::VectorXd& at_points) {
  constexpr Eigen::Index considered = 7;
  const PointNeighbours nearest = nearest_among(samples.points, proxy().points, considered);
  const Eigen::Index count = nearest.indices.cols();
  Eigen::VectorXd values(samples.points.rows());
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    // Weights decrease to 0 at the farthest point considered, which makes values continuous where the set changes.
    const double reach = nearest.distances(i, count - 1) * (1 + 1e-9);
    double sum = 0;
    double weights = 0;
    for (Eigen::Index k = 0; k < count; ++k) {
      const std::int32_t point = nearest.indices(i, k);
      const double fall = reach > 0 ? 1 - nearest.distances(i, k) / reach : 1;
      const double agreement = std::abs(proxy().normals.row(point).dot(samples.normals.row(i)));
      const double weight = fall * fall * (agreement * agreement + 1e-6);
      sum += weight * at_points[point];
      weights += weight;
    }
    values[i] = sum / weights;
  }
  return values;
}

}  // namespace shapegauge
