#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace shapegauge {

/// A mixture of normal distributions with diagonal covariances.
struct GaussianMixture {
  Eigen::VectorXd weights;    ///< of the k components; they sum to 1
  Eigen::MatrixXd means;      ///< k x d
  Eigen::MatrixXd variances;  ///< k x d
  double log_likelihood = 0;  ///< of the points that it was fitted to: the sum of the logarithms of their densities
};

/// How a mixture is fitted.
struct MixtureOptions {
  int components = 0;            ///< wanted; fewer where there are fewer points. 0: by the criterion, up to `most`
  int most_components = 10;      ///< tried for the criterion; at least 1
  int restarts = 5;              ///< how many starts the best one is taken of; at least 1
  int iterations = 200;          ///< of expectation and maximisation, at most; at least 1
  double regularisation = 1e-2;  ///< added to each variance, as a share of that of all points in that coordinate; > 0
  std::uint64_t seed = 1;
};

/// Fits a mixture to points, one a row, by expectation maximisation (Dempster, Laird, Rubin 1977), starting from
/// k-means++ centres (Arthur and Vassilvitskii 2007). Where the number of components is not given, it is the one of
/// least Bayesian information criterion (Schwarz 1978), -2 log L + (2 k d + k - 1) log n. A component that dies out
/// keeps a weight of 0. Coordinates in which the points do not differ say nothing.
///
/// Throws InputError for options out of range, and ArgumentError for no points or one that is not finite.
GaussianMixture fit_gaussian_mixture(const Eigen::MatrixXd& points, const MixtureOptions& options);

/// Logarithm of the density of each component, its weight included, at each point: points x components.
Eigen::MatrixXd log_densities(const GaussianMixture& mixture, const Eigen::MatrixXd& points);

/// Probability of each component for each point: points x components, rows that sum to 1.
Eigen::MatrixXd component_probabilities(const GaussianMixture& mixture, const Eigen::MatrixXd& points);

}  // namespace shapegauge
