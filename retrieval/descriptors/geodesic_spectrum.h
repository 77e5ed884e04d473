#pragma once

#include <Eigen/Core>

#include "shapegauge/core/fields/proxy_source.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

/// Cache version; increment when features change. The version of the proxy is added (version_on_proxy()).
inline constexpr int geodesic_spectrum_version = 1;

/// Settings of geodesic_spectrum().
struct GeodesicSpectrumOptions {
  int eigenvalues = 20;  ///< ratios of eigenvalues, the largest eigenvalue not counted
};

/// Geodesic spectrum (after Smeets, Hermans, Vandermeulen, Suetens 2012): eigenvalues l_1, l_2, ... of the matrix of
/// geodesic distances between landmarks of the surface proxy, each entry times the square roots of the two landmarks'
/// areas, in descending order of absolute value. Features are log(|l_k+1| / |l_1|); they do not change with scale, and
/// hardly where the surface bends. Of proxies with fewer landmarks the missing ones repeat the last. Compared by L2.
///
/// Throws InputError for options out of range and as surface_proxy().
Eigen::VectorXf geodesic_spectrum(ProxySource& source, const GeodesicSpectrumOptions& options = {});

/// The absolute values of the `count` eigenvalues of a symmetric matrix that are largest in absolute value, in
/// descending order, by Lanczos iteration (Spectra); fewer where the matrix has fewer rows. Throws InputError where the
/// iteration does not converge.
Eigen::VectorXd dominant_eigenvalues(const Eigen::MatrixXd& matrix, Eigen::Index count);

Descriptor geodesic_spectrum_descriptor();

}  // namespace shapegauge
