// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/retrieval/descriptors/geodesic_spectrum.h"

#include <Spectra/MatOp/DenseSymMatProd.h>
#include <Spectra/SymEigsSolver.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "shapegauge/core/base/decompositions.h"
#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/fields/proxy_source.h"
#include "shapegauge/retrieval/distances.h"

namespace shapegauge {

namespace {

constexpr std::array geodesic_spectrum_table = {
    option_of<&GeodesicSpectrumOptions::eigenvalues>(
        "eigenvalues", {.low = 1, .high = 100},
        "Number of eigenvalues after the largest, each divided by the largest."),
};
constexpr auto geodesic_spectrum_parameters = parameters_of(geodesic_spectrum_table);

/// Returns the distances between landmarks, weighted by the square roots of their areas on both sides.
Eigen::MatrixXd weighted_distances(const ProxyGeodesics& geodesics) {
  const Eigen::Index count = geodesics.areas.size();
  const Eigen::VectorXd roots = (geodesics.areas / geodesics.areas.sum()).cwiseSqrt();
  Eigen::MatrixXd distances = geodesics.distances.topRows(count).cast<double>();
  distances = (0.5 * (distances + distances.transpose())).eval();
  return roots.asDiagonal() * distances * roots.asDiagonal();
}

Eigen::VectorXd descending_sizes(const Eigen::VectorXd& eigenvalues, Eigen::Index count) {
  Eigen::VectorXd sizes = eigenvalues.cwiseAbs();
  std::sort(sizes.begin(), sizes.end(), std::greater<>());
  return sizes.head(std::min(count, sizes.size()));
}

}  // namespace

Eigen::VectorXd dominant_eigenvalues(const Eigen::MatrixXd& matrix, Eigen::Index count) {
  check_interruption();
  const Eigen::Index basis = 3 * count;
  if (matrix.rows() <= 2 * basis) {  // faster directly
    return descending_sizes(eigen_decomposition(matrix, Eigen::EigenvaluesOnly).eigenvalues(), count);
  }
  Spectra::DenseSymMatProd<double> product(matrix);
  Spectra::SymEigsSolver<Spectra::DenseSymMatProd<double>> solver(product, count, basis);
  solver.init();
  constexpr Eigen::Index max_iterations = 300;
  constexpr double tolerance = 1e-8;
  solver.compute(Spectra::SortRule::LargestMagn, max_iterations, tolerance);
  if (solver.info() != Spectra::CompInfo::Successful) {
    throw InputError("the " + std::to_string(count) +
                     " largest eigenvalues of the geodesic distances did not converge; reduce eigenvalues");
  }
  return descending_sizes(solver.eigenvalues(), count);
}

Eigen::VectorXf geodesic_spectrum(ProxySource& source, const GeodesicSpectrumOptions& options) {
  check_options("geodesic_spectrum", geodesic_spectrum_table, options);
  const Eigen::VectorXd sizes = dominant_eigenvalues(weighted_distances(source.geodesics()), options.eigenvalues + 1);
  // Far below the smallest ratio of surfaces, which is about 1e-4 for 20 eigenvalues.
  constexpr double least = 1e-9;
  Eigen::VectorXf features(options.eigenvalues);
  for (Eigen::Index k = 0; k < features.size(); ++k) {
    const double size = sizes[std::min(k + 1, sizes.size() - 1)];
    features[k] = static_cast<float>(std::log(std::max(size / sizes[0], least)));
  }
  return features;
}

Descriptor geodesic_spectrum_descriptor() {
  return {.name = "geodesic_spectrum",
          .description = "Eigenvalues of the geodesic distance matrix of landmarks (after Smeets et al. 2012).",
          .parameters = geodesic_spectrum_parameters,
          .version = version_on_proxy(1),
          .describe =
              [](const DescriptorInput& input, const LearntFeatures&, const DescriptorSettings& settings) {
                const GeodesicSpectrumOptions options = options_from(geodesic_spectrum_table, settings.values);
                return call_with_proxy(input, [&](ProxySource& source) { return geodesic_spectrum(source, options); });
              },
          .distance = l2_distance};
}

}  // namespace shapegauge
