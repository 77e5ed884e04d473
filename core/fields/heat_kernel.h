#pragma once

#include <Eigen/Core>
#include <array>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/fields/laplacian.h"

namespace shapegauge {

/// To be raised with every change of the signatures here, or of the spectrum, that changes a value: what a cache holds
/// of earlier versions is then computed anew.
inline constexpr int heat_kernel_version = 3;

/// Heat kernel signature (Sun, Ovsjanikov, Guibas 2009) at the vertices: the sum over the spectrum of
/// exp(-lambda t) phi(x)^2, times the area: the heat left at a place from a unit put there, relative to its share when
/// it has spread evenly; 1 for late times. The time is in units of the area: the signature does not depend on the
/// scale. Throws InputError unless the time is positive.
Eigen::VectorXd heat_kernel_signature(const Spectrum& spectrum, double area, double time);

/// Settings of scale_invariant_heat_kernel_signature().
struct ScaleInvariantOptions {
  double first_time = 0.0005;  ///< positive, in units of the surface area
  double last_time = 2;        ///< greater than the first
  int times = 128;             ///< 4 to 10000; spaced evenly by their logarithm
  int frequencies = 6;         ///< 1 to times / 2
};

/// Scale-invariant heat kernel signature (Bronstein and Kokkinos 2010): the derivative of the logarithm of the heat
/// kernel signature by the logarithm of time, whose translation is a change of scale, and of that the magnitudes of its
/// first discrete Fourier coefficients, one a column. Throws InputError for options out of range.
Eigen::MatrixXd scale_invariant_heat_kernel_signature(const Spectrum& spectrum, double area,
                                                      const ScaleInvariantOptions& options = {});

/// Settings of wave_kernel_signature().
struct WaveKernelOptions {
  int energies = 16;       ///< evenly spaced between the logarithms of the spectrum's ends
  double width_steps = 7;  ///< standard deviation of a filter by energy, in steps of a hundred, as published
};

/// What may be chosen of WaveKernelOptions.
inline constexpr std::array wave_kernel_table = {
    option_of<&WaveKernelOptions::energies>("energies", {.low = 2, .high = 1000},
                                            "How many there are, evenly spaced by their logarithm."),
    option_of<&WaveKernelOptions::width_steps>("width_steps", {.low = 0.1, .high = 100},
                                               "Standard deviation of a filter, in hundredths of the range of "
                                               "energies."),
};

/// Wave kernel signature (Aubry, Schlickewei, Cremers 2011) at the vertices: column k is the mean of phi(x)^2 over the
/// spectrum, weighted by a Gaussian of log lambda about the energy e_k, times the area. The zero eigenvalues do not
/// count. Throws InputError for options out of range and for a spectrum with fewer than two positive eigenvalues.
Eigen::MatrixXd wave_kernel_signature(const Spectrum& spectrum, double area, const WaveKernelOptions& options = {});

}  // namespace shapegauge
