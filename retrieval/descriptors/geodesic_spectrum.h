// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

/// Options of geodesic_spectrum().
struct GeodesicSpectrumOptions {
  int eigenvalues = 20;  ///< number of features: eigenvalues after the largest one, divided by the largest
};

/// Computes the geodesic spectrum (after Smeets, Hermans, Vandermeulen, Suetens 2012): eigenvalues l_1, l_2, ... of the
/// matrix of geodesic distances between landmarks of the surface proxy, in descending order of absolute value. Each
/// entry is weighted by the square roots of the two landmarks' areas. Features are log(|l_k+1| / |l_1|): invariant to
/// scale, and nearly invariant to bending. If the proxy has fewer landmarks, the last feature is repeated. Compared by
/// L2.
///
/// Throws InputError for options out of range and as surface_proxy() does.
Eigen::VectorXf geodesic_spectrum(ProxySource& source, const GeodesicSpectrumOptions& options = {});

/// Computes the absolute values of the `count` largest eigenvalues, by absolute value, of a symmetric matrix by Lanczos
/// iteration (Spectra), in descending order; fewer if the matrix has fewer rows. Throws InputError if the iteration
/// does not converge.
Eigen::VectorXd dominant_eigenvalues(const Eigen::MatrixXd& matrix, Eigen::Index count);

/// Returns the entry "geodesic_spectrum" of the registry descriptors().
Descriptor geodesic_spectrum_descriptor();

}  // namespace shapegauge
