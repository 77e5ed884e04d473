// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/segmentation/gaussian_mixture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/spatial/k_means_seeds.h"

namespace shapegauge {

namespace {

constexpr double min_gain = 1e-9;  ///< of the log-likelihood, relative to its size, for another iteration
constexpr int max_maximisations = 200;
constexpr std::uint64_t mixture_starts = 5;
constexpr double variance_share = 1e-2;  ///< added to each variance, relative to that of all points

/// Returns the minimum variance of components by coordinate.
Eigen::RowVectorXd min_variances(const Eigen::MatrixXd& points) {
  const Eigen::RowVectorXd mean = points.colwise().mean();
  const Eigen::RowVectorXd variance = (points.rowwise() - mean).array().square().colwise().mean();
  // A constant coordinate gets any variance, since it distinguishes no points.
  return variance.unaryExpr([](double v) { return v > 0 ? variance_share * v : 1.0; });
}

/// Returns the logarithm of the sum of each row's exponentials.
Eigen::VectorXd log_sums(const Eigen::MatrixXd& rows) {
  const Eigen::VectorXd largest = rows.rowwise().maxCoeff();
  return largest.array() + (rows.colwise() - largest).array().exp().rowwise().sum().log();
}

/// Chooses initial means in scaled coordinates (k_means_seeds()).
Eigen::MatrixXd spread_centres(const Eigen::MatrixXd& points, const Eigen::RowVectorXd& scale, Eigen::Index count,
                               RandomNumbers& random) {
  const auto squared_distances = [&](Eigen::Index from) {
    Eigen::VectorXd distances(points.rows());
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      distances[i] = ((points.row(i) - points.row(from)).array() / scale.array()).square().sum();
    }
    return distances;
  };
  std::vector<Eigen::Index> seeds = k_means_seeds(points.rows(), count, random, squared_distances);
  seeds.resize(static_cast<std::size_t>(count), points.rows() - 1);  // if all other points coincide with a centre
  return points(seeds, Eigen::all);
}

GaussianMixture maximised(const Eigen::MatrixXd& points, const Eigen::MatrixXd& probabilities,
                          const Eigen::RowVectorXd& least) {
  GaussianMixture mixture;
  const Eigen::VectorXd counts = probabilities.colwise().sum();
  mixture.weights = counts / static_cast<double>(points.rows());
  mixture.means = probabilities.transpose() * points;
  mixture.variances.resizeLike(mixture.means);
  for (Eigen::Index k = 0; k < counts.size(); ++k) {
    const double count = std::max(counts[k], std::numeric_limits<double>::min());
    mixture.means.row(k) /= count;
    const auto squares = (points.rowwise() - mixture.means.row(k)).array().square().matrix();
    mixture.variances.row(k) = probabilities.col(k).transpose() * squares / count + least;
  }
  return mixture;
}

GaussianMixture fitted_from(const Eigen::MatrixXd& points, const Eigen::MatrixXd& centres,
                            const Eigen::RowVectorXd& least) {
  GaussianMixture mixture;
  mixture.weights = Eigen::VectorXd::Constant(centres.rows(), 1 / static_cast<double>(centres.rows()));
  mixture.means = centres;
  const Eigen::RowVectorXd mean = points.colwise().mean();
  const Eigen::RowVectorXd variance = (points.rowwise() - mean).array().square().colwise().mean();
  mixture.variances = (variance + least).replicate(centres.rows(), 1);
  double before = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < max_maximisations; ++i) {
    check_interruption();
    const Eigen::MatrixXd densities = log_densities(mixture, points);
    const Eigen::VectorXd sums = log_sums(densities);
    mixture.log_likelihood = sums.sum();
    if (!(mixture.log_likelihood - before > min_gain * std::abs(mixture.log_likelihood))) break;
    before = mixture.log_likelihood;
    mixture = maximised(points, (densities.colwise() - sums).array().exp(), least);
    mixture.log_likelihood = log_sums(log_densities(mixture, points)).sum();
  }
  return mixture;
}

}  // namespace

Eigen::MatrixXd log_densities(const GaussianMixture& mixture, const Eigen::MatrixXd& points) {
  Eigen::MatrixXd densities(points.rows(), mixture.weights.size());
  for (Eigen::Index k = 0; k < densities.cols(); ++k) {
    const Eigen::RowVectorXd variances = mixture.variances.row(k);
    const double scale = std::log(mixture.weights[k]) - 0.5 * (2 * std::numbers::pi * variances.array()).log().sum();
    const auto offsets = (points.rowwise() - mixture.means.row(k)).array().square().rowwise() / variances.array();
    densities.col(k) = scale - 0.5 * offsets.rowwise().sum();
  }
  return densities;
}

Eigen::MatrixXd component_probabilities(const GaussianMixture& mixture, const Eigen::MatrixXd& points) {
  const Eigen::MatrixXd densities = log_densities(mixture, points);
  return (densities.colwise() - log_sums(densities)).array().exp();
}

GaussianMixture fit_gaussian_mixture(const Eigen::MatrixXd& points, Eigen::Index components) {
  if (points.rows() == 0 || points.cols() == 0) {
    throw ArgumentError("a Gaussian mixture needs at least one point and one dimension, not " +
                        std::to_string(points.rows()) + " and " + std::to_string(points.cols()));
  }
  if (!points.allFinite())
    throw ArgumentError("points of a Gaussian mixture must be finite numbers (not finite: " +
                        std::to_string((!points.array().isFinite()).count()) + " of " + std::to_string(points.size()) +
                        ")");
  const Eigen::RowVectorXd least = min_variances(points);
  GaussianMixture best;
  for (std::uint64_t start = 0; start < mixture_starts; ++start) {
    RandomNumbers random(1, start);
    const Eigen::Index count = std::min(points.rows(), components);
    GaussianMixture mixture = fitted_from(points, spread_centres(points, least.cwiseSqrt(), count, random), least);
    if (start == 0 || mixture.log_likelihood > best.log_likelihood) best = std::move(mixture);
  }
  return best;
}

}  // namespace shapegauge
