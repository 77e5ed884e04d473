#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace shapegauge {

/// Gaussian mixture with diagonal covariances.
struct GaussianMixture {
  Eigen::VectorXd weights;    ///< weights of the k components; sum 1
  Eigen::MatrixXd means;      ///< k x d
  Eigen::MatrixXd variances;  ///< k x d
  double log_likelihood = 0;  ///< sum of log densities of the points that it was fitted to
};

/// Options of fit_gaussian_mixture().
struct MixtureOptions {
  int components =
      0;  ///< number of components, limited by the number of points. 0: chosen by the Bayesian information criterion
  int max_components = 10;       ///< maximum number chosen by the criterion; at least 1
  int restarts = 5;              ///< number of starts, of which the best is kept; at least 1
  int iterations = 200;          ///< maximum number of iterations of expectation maximisation; at least 1
  double regularisation = 1e-2;  ///< added to each variance, relative to that of all points in that coordinate; > 0
  std::uint64_t seed = 1;
};

/// Fits a Gaussian mixture to points, one a row, by expectation maximisation (Dempster, Laird, Rubin 1977), starting
/// from k-means++ centres (Arthur and Vassilvitskii 2007). If the number of components is not given, minimises the
/// Bayesian information criterion (Schwarz 1978), -2 log L + (2 k d + k - 1) log n. A component that becomes empty
/// keeps a weight of 0. Constant coordinates are ignored.
///
/// Throws InputError for options out of range, and ArgumentError without points and for a point that is not finite.
GaussianMixture fit_gaussian_mixture(const Eigen::MatrixXd& points, const MixtureOptions& options);

/// Computes the log density of each component, including its weight, at each point: points x components.
Eigen::MatrixXd log_densities(const GaussianMixture& mixture, const Eigen::MatrixXd& points);

/// Computes the probability of each component for each point: points x components, rows that sum to 1.
Eigen::MatrixXd component_probabilities(const GaussianMixture& mixture, const Eigen::MatrixXd& points);

}  // namespace shapegauge
