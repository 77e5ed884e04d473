#include "shapegauge/segmentation/gaussian_mixture.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/spatial/k_means_seeds.h"

namespace shapegauge {

namespace {

constexpr double min_gain = 1e-9;  ///< of the log-likelihood, relative to its size, for another iteration

/// Returns the minimum variance of components by coordinate.
Eigen::RowVectorXd min_variances(const Eigen::MatrixXd& points, double share) {
  const Eigen::RowVectorXd mean = points.colwise().mean();
  const Eigen::RowVectorXd variance = (points.rowwise() - mean).array().square().colwise().mean();
  // A constant coordinate gets any variance, since it distinguishes no points.
  return variance.unaryExpr([&](double v) { return v > 0 ? share * v : 1.0; });
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
                            const Eigen::RowVectorXd& least, int iterations) {
  GaussianMixture mixture;
  mixture.weights = Eigen::VectorXd::Constant(centres.rows(), 1 / static_cast<double>(centres.rows()));
  mixture.means = centres;
  const Eigen::RowVectorXd mean = points.colwise().mean();
  const Eigen::RowVectorXd variance = (points.rowwise() - mean).array().square().colwise().mean();
  mixture.variances = (variance + least).replicate(centres.rows(), 1);
  double before = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < iterations; ++i) {
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

GaussianMixture best_fit(const Eigen::MatrixXd& points, int components, const MixtureOptions& options) {
  const Eigen::RowVectorXd least = min_variances(points, options.regularisation);
  GaussianMixture best;
  for (int restart = 0; restart < options.restarts; ++restart) {
    RandomNumbers random(options.seed, static_cast<std::uint64_t>(restart));
    const Eigen::MatrixXd centres = spread_centres(points, least.cwiseSqrt(), components, random);
    GaussianMixture mixture = fitted_from(points, centres, least, options.iterations);
    if (restart == 0 || mixture.log_likelihood > best.log_likelihood) best = std::move(mixture);
  }
  return best;
}

double information_criterion(const GaussianMixture& mixture, Eigen::Index points) {
  const Eigen::Index parameters = 2 * mixture.means.size() + mixture.weights.size() - 1;
  return -2 * mixture.log_likelihood + static_cast<double>(parameters) * std::log(static_cast<double>(points));
}

void check(const Eigen::MatrixXd& points, const MixtureOptions& options) {
  if (points.rows() == 0 || points.cols() == 0) throw ArgumentError("a mixture needs points");
  if (!points.allFinite()) throw ArgumentError("a mixture needs points that are finite");
  if (options.components < 0) throw InputError(fmt::format("there cannot be {} components", options.components));
  if (options.max_components < 1) {
    throw InputError(fmt::format("at least 1 component must be allowed, not {}", options.max_components));
  }
  if (options.restarts < 1) throw InputError(fmt::format("at least 1 start is needed, not {}", options.restarts));
  if (options.iterations < 1)
    throw InputError(fmt::format("at least 1 iteration is needed, not {}", options.iterations));
  if (!(options.regularisation > 0 && std::isfinite(options.regularisation))) {
    throw InputError(fmt::format("the regularisation must be greater than 0, not {}", options.regularisation));
  }
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

GaussianMixture fit_gaussian_mixture(const Eigen::MatrixXd& points, const MixtureOptions& options) {
  check(points, options);
  const int most = static_cast<int>(std::min<Eigen::Index>(points.rows(), options.max_components));
  if (options.components > 0) {
    const auto components = static_cast<int>(std::min<Eigen::Index>(points.rows(), options.components));
    return best_fit(points, components, options);
  }
  GaussianMixture best = best_fit(points, 1, options);
  for (int components = 2; components <= most; ++components) {
    GaussianMixture mixture = best_fit(points, components, options);
    if (information_criterion(mixture, points.rows()) < information_criterion(best, points.rows())) {
      best = std::move(mixture);
    }
  }
  return best;
}

}  // namespace shapegauge
