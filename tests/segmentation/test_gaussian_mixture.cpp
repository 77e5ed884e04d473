// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/segmentation/gaussian_mixture.h"

namespace shapegauge {
namespace {

/// `each` points about each centre, with standard deviation 1 (sums of twelve uniform numbers).
Eigen::MatrixXd clouds(const std::vector<Eigen::RowVector2d>& centres, int each) {
  RandomNumbers random(5);
  Eigen::MatrixXd points(std::ssize(centres) * each, 2);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    points.row(i) = centres[static_cast<std::size_t>(i / each)];
    for (double& x : points.row(i)) {
      for (int k = 0; k < 12; ++k) x += random.uniform(-0.5, 0.5);
    }
  }
  return points;
}

const std::vector<Eigen::RowVector2d> three_centres = {{0, 0}, {10, 0}, {0, 10}};

TEST(GaussianMixture, FindsTheComponentsThatPointsWereDrawnFrom) {
  const GaussianMixture mixture = fit_gaussian_mixture(clouds(three_centres, 400), 3);
  for (const Eigen::RowVector2d& centre : three_centres) {
    Eigen::Index nearest = 0;
    // 400 points of deviation 1: the mean is off by 0.05, the variance by 0.07 and the regularisation of 0.2.
    EXPECT_LT((mixture.means.rowwise() - centre).rowwise().norm().minCoeff(&nearest), 0.2);
    EXPECT_NEAR(mixture.weights[nearest], 1.0 / 3, 0.01);
    EXPECT_NEAR(mixture.variances(nearest, 0), 1.2, 0.3);
  }
}

TEST(GaussianMixture, DensityOfOneComponentMatchesTheNormalDistribution) {
  GaussianMixture mixture;
  mixture.weights = Eigen::VectorXd::Constant(1, 0.25);
  mixture.means = Eigen::MatrixXd::Constant(1, 1, 2);
  mixture.variances = Eigen::MatrixXd::Constant(1, 1, 9);
  const double expected = 0.25 * std::exp(-0.5) / (3 * std::sqrt(2 * std::numbers::pi));
  EXPECT_NEAR(std::exp(log_densities(mixture, Eigen::MatrixXd::Constant(1, 1, 5))(0, 0)), expected, 1e-15);
}

TEST(GaussianMixture, OfOneComponentHasTheMeanAndTheVarianceOfThePoints) {
  const Eigen::MatrixXd points{{1, 5}, {2, 5}, {4, 5}, {5, 5}};  // the second coordinate is constant
  const GaussianMixture mixture = fit_gaussian_mixture(points, 1);
  EXPECT_DOUBLE_EQ(mixture.weights[0], 1);
  EXPECT_DOUBLE_EQ(mixture.means(0, 0), 3);
  EXPECT_DOUBLE_EQ(mixture.variances(0, 0), 1.01 * 2.5);
  EXPECT_DOUBLE_EQ(mixture.variances(0, 1), 1);
  EXPECT_NEAR(mixture.log_likelihood, log_densities(mixture, points).sum(), 1e-12);
}

TEST(GaussianMixture, ComponentProbabilitiesAreProportionalToWeightTimesDensity) {
  GaussianMixture mixture;
  mixture.weights = Eigen::Vector2d(0.75, 0.25);
  mixture.means = Eigen::Vector2d(0, 2);
  mixture.variances = Eigen::Vector2d(1, 4);
  const double first = 0.75 * std::exp(-0.5);
  const double second = 0.25 * std::exp(-0.125) / 2;
  const Eigen::MatrixXd probabilities = component_probabilities(mixture, Eigen::MatrixXd::Constant(1, 1, 1));
  EXPECT_NEAR(probabilities(0, 0), first / (first + second), 1e-12);
  EXPECT_NEAR(probabilities(0, 1), second / (first + second), 1e-12);
}

TEST(GaussianMixture, ProbabilitiesOfAPointSumToOneAtAnyDistance) {
  const Eigen::MatrixXd points = clouds(three_centres, 20);
  const GaussianMixture mixture = fit_gaussian_mixture(points, 3);
  const Eigen::MatrixXd probabilities = component_probabilities(mixture, 1e6 * points);
  EXPECT_TRUE((probabilities.rowwise().sum().array() - 1).abs().maxCoeff() < 1e-12);
  EXPECT_GE(probabilities.minCoeff(), 0);
}

TEST(GaussianMixture, IsFiniteForCoincidentPoints) {
  const GaussianMixture mixture = fit_gaussian_mixture(Eigen::MatrixXd::Constant(5, 2, 3), 3);
  EXPECT_TRUE(mixture.means.allFinite());
  EXPECT_TRUE(component_probabilities(mixture, Eigen::MatrixXd::Constant(1, 2, 3)).allFinite());
}

TEST(GaussianMixture, HasNoMoreComponentsThanPoints) {
  EXPECT_EQ(fit_gaussian_mixture(clouds({{0, 0}}, 2), 7).weights.size(), 2);
}

TEST(GaussianMixture, RejectsEmptyAndNonFinitePoints) {
  EXPECT_THROW(fit_gaussian_mixture(Eigen::MatrixXd(0, 2), 1), ArgumentError);
  EXPECT_THROW(fit_gaussian_mixture(Eigen::MatrixXd::Constant(2, 2, NAN), 1), ArgumentError);
}

}  // namespace
}  // namespace shapegauge
