// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

/// Options of spherical_harmonics().
struct SphericalHarmonicsOptions {
  int shells = 32;     ///< number of concentric spheres; the last has twice the mean distance of the surface from its
                       ///< centroid as radius
  int bandwidth = 16;  ///< number of spherical harmonic frequencies on each sphere, from 0 on
  double width =
      1.0 / 8;          ///< w of exp(-(d / w)^2) of the distance d to the surface, in mean distances from the centroid
  bool voxels = false;  ///< describe the surface as voxels, as thick as a shell, instead of by the Gaussian
};

/// Spherical harmonic transform of functions on the sphere to one norm per frequency. The bandwidth is at least 1.
class HarmonicTransform {
 public:
  explicit HarmonicTransform(int bandwidth);  ///< `bandwidth` is the number of frequencies, from 0 on

  /// Returns the directions at which a function must be sampled, one per row: 2 bandwidth circles of latitude
  /// (Gauss-Legendre) times 4 bandwidth meridians.
  [[nodiscard]] const Points& directions() const { return directions_; }

  /// Computes sqrt(sum over m of |a_lm|^2) for each frequency l below the bandwidth, where a_lm are the coefficients of
  /// the function in orthonormal spherical harmonics. Invariant to rotations of the function. Exact for functions whose
  /// frequencies are below twice the bandwidth. Throws ArgumentError unless there is one value for each direction.
  [[nodiscard]] Eigen::VectorXd norms(const Eigen::VectorXd& values) const;

 private:
  Eigen::MatrixXd cosines_;  ///< cos(m longitude) of harmonics of order m, with quadrature weights: meridians x orders
  Eigen::MatrixXd sines_;    ///< sin(m longitude) of harmonics of order m, with quadrature weights: meridians x orders
  std::vector<Eigen::MatrixXd> by_frequency_;  ///< per frequency: weighted Legendre functions, circles x orders
  Points directions_;                          ///< unit vectors of the samples, one per row
};

/// Computes the rotation-invariant spherical harmonic descriptor (Kazhdan, Funkhouser, Rusinkiewicz 2003): norms per
/// sphere and frequency of a function restricted to spheres about the surface's centroid. The norms are weighted by the
/// sphere's radius, which makes L2 compare volumes. The function is the Gaussian of the distance to the surface, as
/// evaluated by the Princeton Shape Benchmark, or the voxelised surface.
///
/// Invariant to scale, position, orientation, closedness and connectivity. Clouds are described by their points. Throws
/// InputError for options out of range, an unusable shape, and one without extent or area.
Eigen::VectorXf spherical_harmonics(const Shape& shape, const SphericalHarmonicsOptions& options = {});

/// Returns the entry "spherical_harmonics" of the registry descriptors().
Descriptor spherical_harmonics_descriptor();

}  // namespace shapegauge
