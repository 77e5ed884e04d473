// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <complex>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/fields/heat_kernel.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

using test::sphere;

Spectrum spectrum_of(const Shape& shape, int count = 40) { return laplacian_spectrum(shape, count); }

TEST(HeatKernel, SignatureOfASphereMatchesTheSeriesOfSphericalHarmonics) {
  const Shape shape = sphere(1, 4);
  const double area = surface_area(shape);
  const Spectrum spectrum = spectrum_of(shape, 49);
  for (const double time : {0.02, 0.05, 0.1}) {
    const Eigen::VectorXd found = heat_kernel_signature(spectrum, area, time);
    double series = 0;
    for (int l = 0; l < 7; ++l) series += (2 * l + 1) * std::exp(-l * (l + 1) * time * area);
    EXPECT_NEAR(found.minCoeff(), series, 0.02 * series);
    EXPECT_NEAR(found.maxCoeff(), series, 0.02 * series);
  }
}

TEST(HeatKernel, AreaWeightedSumIsTheHeatTrace) {
  const Shape shape = test::capsule(0.5, 2, 16, 24);
  const Laplacian laplacian = cotangent_laplacian(shape);
  const Spectrum spectrum = spectrum_of(shape);
  const Eigen::VectorXd found = heat_kernel_signature(spectrum, 1, 0.5);
  double mean = 0;
  for (std::size_t v = 0; v < laplacian.node_of.size(); ++v) {
    mean += laplacian.mass[laplacian.node_of[v]] * found[static_cast<Eigen::Index>(v)];
  }
  EXPECT_NEAR(mean, (-0.5 * spectrum.eigenvalues).array().exp().sum(), 1e-6);
}

TEST(HeatKernel, SignatureIsUniformAtLateTimesAndLargestAtTipsEarly) {
  const Shape shape = test::box({0.4, 0.4, 3}, 12);
  const Spectrum spectrum = spectrum_of(shape);
  const Eigen::VectorXd late = heat_kernel_signature(spectrum, surface_area(shape), 100);
  EXPECT_NEAR(late.minCoeff(), 1, 1e-6);
  EXPECT_NEAR(late.maxCoeff(), 1, 1e-6);
  Eigen::Index greatest = 0;
  heat_kernel_signature(spectrum, surface_area(shape), 0.05).maxCoeff(&greatest);
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
  EXPECT_LT(largest_difference(heat_kernel_signature(a, area, 0.01), heat_kernel_signature(b, 49 * area, 0.01)), 1e-5);
  EXPECT_LT(largest_difference(wave_kernel_signature(a, area), wave_kernel_signature(b, 49 * area)), 1e-4);
  EXPECT_LT(largest_difference(scale_invariant_heat_kernel_signature(a, area),
                               scale_invariant_heat_kernel_signature(b, 49 * area)),
            1e-5);
}

TEST(HeatKernel, ScaleInvariantSignatureDoesNotDependOnTheArea) {
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

/// Direct evaluation of the definition: the derivative of the logarithm by the logarithm of time, and the magnitudes of
/// its discrete Fourier transform, as approximations of integrals.
Eigen::VectorXd scale_invariant_by_definition(const Spectrum& spectrum, Eigen::Index vertex, double area,
                                              const ScaleInvariantOptions& options) {
  const int steps = options.times - 1;
  const double step = std::log(options.last_time / options.first_time) / steps;
  std::vector<double> logarithm;
  for (int i = 0; i < options.times; ++i) {
    const double t = options.first_time * std::exp(i * step) * area;
    double kernel = 0;
    for (Eigen::Index k = 0; k < spectrum.eigenvalues.size(); ++k) {
      kernel += std::exp(-spectrum.eigenvalues[k] * t) * std::pow(spectrum.eigenvectors(vertex, k), 2);
    }
    logarithm.push_back(std::log(area * kernel));
  }
  Eigen::VectorXd magnitudes(options.frequencies);
  for (int k = 0; k < options.frequencies; ++k) {
    std::complex<double> sum = 0;
    for (int i = 0; i < steps; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double derivative = (logarithm[at + 1] - logarithm[at]) / step;
      sum += derivative * std::polar(1.0, -2 * std::numbers::pi * i * k / steps) * step;
    }
    magnitudes[k] = std::abs(sum);
  }
  return magnitudes;
}

TEST(HeatKernel, ScaleInvariantSignatureIsTheMagnitudeOfAFourierTransform) {
  const Shape shape = test::capsule(0.3, 2, 12, 8);
  const Spectrum spectrum = spectrum_of(shape, 20);
  const double area = surface_area(shape);
  const ScaleInvariantOptions options = {.first_time = 0.001, .last_time = 1, .times = 20, .frequencies = 6};
  const Eigen::MatrixXd found = scale_invariant_heat_kernel_signature(spectrum, area, options);
  for (const Eigen::Index vertex : {0, 17, 60}) {
    const Eigen::VectorXd expected = scale_invariant_by_definition(spectrum, vertex, area, options);
    for (Eigen::Index k = 0; k < expected.size(); ++k) {
      EXPECT_NEAR(found(vertex, k), expected[k], 1e-10) << "coefficient " << k;
      EXPECT_GT(expected[k], 1e-3) << "coefficient " << k << " says nothing";
    }
  }
}

TEST(HeatKernel, AreaWeightedMeanOfTheWaveKernelSignatureIsOne) {
  const Shape shape = test::capsule(0.5, 2, 16, 24);
  const Laplacian laplacian = cotangent_laplacian(shape);
  const Eigen::MatrixXd found = wave_kernel_signature(spectrum_of(shape), laplacian.mass.sum());
  Eigen::RowVectorXd mean = Eigen::RowVectorXd::Zero(found.cols());
  for (std::size_t v = 0; v < laplacian.node_of.size(); ++v) {
    mean += laplacian.mass[laplacian.node_of[v]] / laplacian.mass.sum() * found.row(static_cast<Eigen::Index>(v));
  }
  EXPECT_LT((mean.array() - 1).abs().maxCoeff(), 1e-6);
}

/// Direct evaluation of the definition: the squares of the eigenfunctions, weighted by a Gaussian of the logarithms of
/// their eigenvalues.
double wave_kernel_by_definition(const Spectrum& spectrum, Eigen::Index vertex, double area, double at, double width) {
  double sum = 0;
  double weights = 0;
  for (Eigen::Index k = 1; k < spectrum.eigenvalues.size(); ++k) {
    const double steps = (at - std::log(spectrum.eigenvalues[k])) / width;
    const double weight = std::exp(-steps * steps / 2);
    sum += weight * std::pow(spectrum.eigenvectors(vertex, k), 2);
    weights += weight;
  }
  return area * sum / weights;
}

TEST(HeatKernel, WaveKernelSignatureMatchesTheDefinition) {
  const Shape shape = test::capsule(0.3, 2, 12, 8);
  const Spectrum spectrum = spectrum_of(shape, 20);
  const double area = surface_area(shape);
  const Eigen::MatrixXd found = wave_kernel_signature(spectrum, area, {.energies = 5, .width_steps = 4});
  const double lowest = std::log(spectrum.eigenvalues[1]);
  const double range = std::log(spectrum.eigenvalues[19]) - lowest;
  for (const Eigen::Index vertex : {0, 17, 60}) {
    for (int k = 0; k < 5; ++k) {
      // Two widths of 4 % of the range from either end.
      const double at = lowest + range * (0.08 + 0.84 * k / 4);
      EXPECT_NEAR(found(vertex, k), wave_kernel_by_definition(spectrum, vertex, area, at, 0.04 * range), 1e-9) << k;
    }
  }
}

TEST(HeatKernel, RefusesOptionsOutOfRange) {
  const Spectrum spectrum = spectrum_of(sphere(1, 1), 8);
  EXPECT_THROW(heat_kernel_signature(spectrum, 1, 0), InputError);
  EXPECT_THROW(wave_kernel_signature(spectrum, 1, {.energies = 1}), InputError);
  EXPECT_THROW(wave_kernel_signature(spectrum, 1, {.width_steps = 0}), InputError);
  EXPECT_THROW(wave_kernel_signature(spectrum_of(sphere(1, 1), 2), 1), InputError);
}

}  // namespace
}  // namespace shapegauge
