// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/fields/heat_kernel.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

namespace {

/// Computes the heat kernel signature, one column for each time, evenly spaced on a logarithmic scale.
Eigen::MatrixXd heat_kernel(const Spectrum& spectrum, double area, const ScaleInvariantOptions& options) {
  const Eigen::ArrayXd t =
      Eigen::ArrayXd::LinSpaced(options.times, std::log(options.first_time), std::log(options.last_time)).exp() * area;
  const Eigen::MatrixXd decay = (-spectrum.eigenvalues * t.matrix().transpose()).array().exp();
  return area * (spectrum.eigenvectors.cwiseAbs2() * decay);
}

/// Eigenvalues below this fraction of the last one are zero up to rounding.
constexpr double zero = 1e-9;

}  // namespace

Eigen::VectorXd heat_kernel_signature(const Spectrum& spectrum, double area, double time) {
  if (!(time > 0 && std::isfinite(time))) {
    throw InputError(fmt::format("the time of a heat kernel must be positive, not {}", time));
  }
  const Eigen::VectorXd decay = (-spectrum.eigenvalues * time * area).array().exp();
  return area * (spectrum.eigenvectors.cwiseAbs2() * decay);
}

Eigen::MatrixXd scale_invariant_heat_kernel_signature(const Spectrum& spectrum, double area,
                                                      const ScaleInvariantOptions& options) {
  const Eigen::MatrixXd logarithm = heat_kernel(spectrum, area, options).array().log();
  const Eigen::Index steps = options.times - 1;
  const double step = std::log(options.last_time / options.first_time) / static_cast<double>(steps);
  const Eigen::MatrixXd derivative = (logarithm.rightCols(steps) - logarithm.leftCols(steps)) / step;
  Eigen::MatrixXd cosines(steps, options.frequencies);
  Eigen::MatrixXd sines(steps, options.frequencies);
  for (Eigen::Index k = 0; k < cosines.cols(); ++k) {
    for (Eigen::Index i = 0; i < steps; ++i) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(i * k) / static_cast<double>(steps);
      cosines(i, k) = std::cos(angle) * step;
      sines(i, k) = std::sin(angle) * step;
    }
  }
  return ((derivative * cosines).cwiseAbs2() + (derivative * sines).cwiseAbs2()).cwiseSqrt();
}

Eigen::MatrixXd wave_kernel_signature(const Spectrum& spectrum, double area, const WaveKernelOptions& options) {
  check_options("wave_kernel", wave_kernel_table, options);
  const Eigen::VectorXd& all = spectrum.eigenvalues;
  const Eigen::Index zeros = (all.array() <= zero * all[all.size() - 1]).count();
  const Eigen::Index positive = all.size() - zeros;
  if (positive < 2)
    throw InputError(fmt::format(
        "a wave kernel signature needs at least 2 positive eigenvalues, found {}; increase eigenvalues", positive));
  const Eigen::VectorXd energy = all.tail(positive).array().log();
  const double lowest = energy[0];
  const double highest = energy[positive - 1];
  // Aubry et al. use a hundred energies and a width of 7 steps; the outer energies keep two widths from the ends.
  const double width = std::max(options.width_steps * (highest - lowest) / 100, 1e-12);
  Eigen::MatrixXd filters(positive, options.energies);
  for (Eigen::Index k = 0; k < filters.cols(); ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(options.energies - 1);
    const double at = lowest + 2 * width + share * std::max(highest - lowest - 4 * width, 0.0);
    filters.col(k) = (-(energy.array() - at).square() / (2 * width * width)).exp();
    filters.col(k) /= filters.col(k).sum();
  }
  return area * (spectrum.eigenvectors.rightCols(positive).cwiseAbs2() * filters);
}

}  // namespace shapegauge
