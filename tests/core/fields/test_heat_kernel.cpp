#include <cmath>
#include <gtest/gtest.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/fields/heat_kernel.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

using test::sphere;

Spectrum spectrum_of(const Shape& shape, int count = 40) { return laplacian_spectrum(shape, count); }

TEST(HeatKernel, OfASphereIsTheSameEverywhereAndAsTheSeriesSays) {
  const Shape shape = sphere(1, 4);
  const double area = surface_area(shape);
  const HeatKernelOptions options = {.first_time = 0.02, .last_time = 0.1, .times = 3};
  const Eigen::MatrixXd found = heat_kernel_signature(spectrum_of(shape, 49), area, options);
  for (int k = 0; k < options.times; ++k) {
    const double t = 0.02 * std::pow(5, k / 2.0) * area;
    double series = 0;
    for (int l = 0; l < 7; ++l) series += (2 * l + 1) * std::exp(-l * (l + 1) * t);
    EXPECT_NEAR(found.col(k).minCoeff(), series, 0.02 * series);
    EXPECT_NEAR(found.col(k).maxCoeff(), series, 0.02 * series);
  }
}

TEST(HeatKernel, MeanByAreaIsTheTrace) {
  const Shape shape = test::capsule(0.5, 2, 16, 24);
  const Laplacian laplacian = cotangent_laplacian(shape);
  const Spectrum spectrum = spectrum_of(shape);
  const Eigen::MatrixXd found = heat_kernel_signature(spectrum, 1, {.first_time = 0.5, .last_time = 5, .times = 2});
  double mean = 0;
  for (std::size_t v = 0; v < laplacian.node_of.size(); ++v) {
    mean += laplacian.mass[laplacian.node_of[v]] * found(static_cast<Eigen::Index>(v), 0);
  }
  EXPECT_NEAR(mean, (-0.5 * spectrum.eigenvalues).array().exp().sum(), 1e-6);
}

TEST(HeatKernel, SpreadsEvenlyInTheEndAndIsGreatestAtTheEnds) {
  const Shape shape = test::box({0.4, 0.4, 3}, 12);
  const Eigen::MatrixXd found = heat_kernel_signature(spectrum_of(shape), surface_area(shape),
                                                      {.first_time = 0.05, .last_time = 100, .times = 2});
  EXPECT_NEAR(found.col(1).minCoeff(), 1, 1e-6);
  EXPECT_NEAR(found.col(1).maxCoeff(), 1, 1e-6);
  Eigen::Index greatest = 0;
  found.col(0).maxCoeff(&greatest);
  EXPECT_GT(std::abs(shape.vertices(greatest, 2)), 1.2);
}

TEST(HeatKernel, SignaturesDoNotChangeWithScaleAndMotion) {
  const Shape shape = test::capsule(0.3, 2, 16, 30);
  const Shape other = test::transformed(shape, 7, test::rotation(1), {1, 2, 3});
  const Spectrum a = spectrum_of(shape);
  const Spectrum b = spectrum_of(other);
  const double area = surface_area(shape);
  const auto largest_difference = [](const Eigen::MatrixXd& x, const Eigen::MatrixXd& y) {
    return (x - y).cwiseAbs().maxCoeff() / x.cwiseAbs().maxCoeff();
  };
  EXPECT_LT(largest_difference(heat_kernel_signature(a, area), heat_kernel_signature(b, 49 * area)), 1e-5);
  EXPECT_LT(largest_difference(wave_kernel_signature(a, area), wave_kernel_signature(b, 49 * area)), 1e-4);
  EXPECT_LT(largest_difference(scale_invariant_heat_kernel_signature(a, area),
                               scale_invariant_heat_kernel_signature(b, 49 * area)),
            1e-5);
}

TEST(HeatKernel, ScaleInvariantSignatureDoesNotNeedTheArea) {
  const Shape shape = test::capsule(0.3, 2, 16, 30);
  const Spectrum spectrum = spectrum_of(shape, 60);
  const double area = surface_area(shape);
  const ScaleInvariantOptions options = {.first_time = 1e-4, .last_time = 20, .times = 256};
  const Eigen::MatrixXd known = scale_invariant_heat_kernel_signature(spectrum, area, options);
  const Eigen::MatrixXd wrong = scale_invariant_heat_kernel_signature(spectrum, 1.5 * area, options);
  // What is flat at both ends of time is only moved, and the magnitudes stay; the plain signature is half as much
  // again.
  EXPECT_LT((known - wrong).cwiseAbs().maxCoeff(), 0.08 * known.maxCoeff());
}

TEST(HeatKernel, MeanOfTheWaveKernelByAreaIsOne) {
  const Shape shape = test::capsule(0.5, 2, 16, 24);
  const Laplacian laplacian = cotangent_laplacian(shape);
  const Eigen::MatrixXd found = wave_kernel_signature(spectrum_of(shape), laplacian.mass.sum());
  Eigen::RowVectorXd mean = Eigen::RowVectorXd::Zero(found.cols());
  for (std::size_t v = 0; v < laplacian.node_of.size(); ++v) {
    mean += laplacian.mass[laplacian.node_of[v]] / laplacian.mass.sum() * found.row(static_cast<Eigen::Index>(v));
  }
  EXPECT_LT((mean.array() - 1).abs().maxCoeff(), 1e-6);
}

TEST(HeatKernel, RefusesOptionsOutOfRange) {
  const Spectrum spectrum = spectrum_of(sphere(1, 1), 8);
  EXPECT_THROW(heat_kernel_signature(spectrum, 1, {.first_time = 0}), InputError);
  EXPECT_THROW(heat_kernel_signature(spectrum, 1, {.first_time = 2, .last_time = 1}), InputError);
  EXPECT_THROW(heat_kernel_signature(spectrum, 1, {.times = 1}), InputError);
  EXPECT_THROW(scale_invariant_heat_kernel_signature(spectrum, 1, {.times = 8, .frequencies = 5}), InputError);
  EXPECT_THROW(wave_kernel_signature(spectrum, 1, {.energies = 1}), InputError);
  EXPECT_THROW(wave_kernel_signature(spectrum, 1, {.width_steps = 0}), InputError);
  EXPECT_THROW(wave_kernel_signature(spectrum_of(sphere(1, 1), 2), 1), InputError);
}

}  // namespace
}  // namespace shapegauge
