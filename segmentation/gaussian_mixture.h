// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace shapegauge {

/// Gaussian mixture with diagonal covariances: k components in d dimensions.
struct GaussianMixture {
  Eigen::VectorXd weights;    ///< weights of the k components, with sum 1
  Eigen::MatrixXd means;      ///< means of the k components in d dimensions: k x d
  Eigen::MatrixXd variances;  ///< variances of the k components along each of the d coordinates: k x d
  double log_likelihood = 0;  ///< sum of the log densities of the points to which the mixture was fitted
};

/// Fits a Gaussian mixture to points, one per row, by expectation maximisation (Dempster, Laird, Rubin 1977), starting
/// from k-means++ centres (Arthur and Vassilvitskii 2007): the best of five starts. `components` is at least 1 and
/// limited by the number of points. A component that becomes empty keeps a weight of 0. Constant coordinates are
/// ignored. Throws ArgumentError without points and for a point that is not finite.
GaussianMixture fit_gaussian_mixture(const Eigen::MatrixXd& points, Eigen::Index components);

/// Computes log(weight * density) of each component at each point: points x components. `points` has one point per row.
Eigen::MatrixXd log_densities(const GaussianMixture& mixture, const Eigen::MatrixXd& points);

/// Computes the posterior probability of each component for each point: points x components. Each row sums to 1.
Eigen::MatrixXd component_probabilities(const GaussianMixture& mixture, const Eigen::MatrixXd& points);

}  // namespace shapegauge
