// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/fields/laplacian.h"

namespace shapegauge {

/// Cache version of the heat and wave kernel signatures and of laplacian_spectrum(); see docs/manual/cache.md.
inline constexpr int heat_kernel_version = 3;

/// Computes the heat kernel signature (Sun, Ovsjanikov, Guibas 2009), one value per vertex of a mesh: the sum over the
/// spectrum (eigenvalues lambda, eigenvectors phi) of exp(-lambda t) phi(x)^2, times the area. It is the heat that
/// remains at a point from a unit of heat placed there, relative to an even distribution; 1 for late times. `area` is
/// the surface area, and t = time * area: the time in units of the area makes the signature independent of scale.
/// Throws InputError unless the time is positive.
Eigen::VectorXd heat_kernel_signature(const Spectrum& spectrum, double area, double time);

/// Options of scale_invariant_heat_kernel_signature().
struct ScaleInvariantOptions {
  double first_time = 0.0005;  ///< earliest diffusion time, positive, in units of the surface area
  double last_time = 2;        ///< latest diffusion time, above first_time, in units of the surface area
  int times = 128;             ///< number of diffusion times, 4 to 10000, evenly spaced on a logarithmic scale
  int frequencies = 6;         ///< number of Fourier coefficients, from frequency 0 on; 1 to times / 2
};

/// Computes the scale-invariant heat kernel signature (Bronstein and Kokkinos 2010). The derivative of the log heat
/// kernel signature by log time turns a change of scale into a translation in time. The signature is the magnitudes of
/// the derivative's first discrete Fourier coefficients: one row per vertex, one column per coefficient. `area` is the
/// surface area.
Eigen::MatrixXd scale_invariant_heat_kernel_signature(const Spectrum& spectrum, double area,
                                                      const ScaleInvariantOptions& options = {});

/// Options of wave_kernel_signature().
struct WaveKernelOptions {
  /// Number of energies, evenly spaced in the range of the log eigenvalues, two standard deviations from its ends.
  int energies = 16;
  /// Standard deviation of an energy's Gaussian, in hundredths of the range of the log eigenvalues.
  double width_steps = 7;
};

/// Names, bounds and help texts of the parameters in WaveKernelOptions (option_parameters.h).
inline constexpr std::array wave_kernel_table = {
    option_of<&WaveKernelOptions::energies>(
        "energies", {.low = 2, .high = 1000},
        "Number of energies, evenly spaced over the logarithms of the eigenvalues."),
    with_unit("hundredths of the energy range",
              option_of<&WaveKernelOptions::width_steps>(
                  "width_steps", {.low = 0.1, .high = 100},
                  "Standard deviation of each energy's Gaussian; larger values average over more eigenvalues.")),
};

/// Computes the wave kernel signature (Aubry, Schlickewei, Cremers 2011), one row per vertex, one column per energy.
/// Column k is the mean of phi(x)^2 over the spectrum (eigenvalues lambda, eigenvectors phi), weighted by a Gaussian of
/// log lambda about the k-th energy, times the surface `area`. Zero eigenvalues are ignored. Throws InputError for
/// options out of range and for a spectrum with fewer than two positive eigenvalues.
Eigen::MatrixXd wave_kernel_signature(const Spectrum& spectrum, double area, const WaveKernelOptions& options = {});

}  // namespace shapegauge
