#pragma once

#include <Eigen/Core>
#include <vector>

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

/// To be raised with every change of spherical_harmonics() that changes a value.
inline constexpr int spherical_harmonics_version = 2;

/// Settings of spherical_harmonics().
struct SphericalHarmonicsOptions {
  int shells = 32;         ///< concentric spheres, the last at twice the surface's mean distance from its centroid
  int bandwidth = 16;      ///< frequencies of each, from 0 on
  double width = 1.0 / 8;  ///< of the Gaussian of the distance to the surface, in mean distances from the centroid
  bool voxels = false;     ///< describe the surface itself, as voxels of a shell's thickness, not the Gaussian
};

/// Norms of functions on the sphere by frequency, for one bandwidth (1 or more).
class HarmonicTransform {
 public:
  explicit HarmonicTransform(int bandwidth);

  /// The directions at which a function is sampled, one a row: 2 bandwidth circles of latitude (Gauss-Legendre) times
  /// 4 bandwidth meridians.
  [[nodiscard]] const Points& directions() const { return directions_; }

  /// sqrt(sum over m of |a_lm|^2) for l below the bandwidth, a_lm being the function's coefficients by orthonormal
  /// spherical harmonics. Rotations of the function do not change them. Exact for functions of less than twice the
  /// bandwidth. Throws ArgumentError where there is not one value for each direction.
  [[nodiscard]] Eigen::VectorXd norms(const Eigen::VectorXd& values) const;

 private:
  Eigen::MatrixXd cosines_;                    ///< meridians x orders
  Eigen::MatrixXd sines_;                      ///< the same
  std::vector<Eigen::MatrixXd> by_frequency_;  ///< circles x orders, with the quadrature's weights
  Points directions_;
};

/// The rotation invariant spherical harmonic descriptor (Kazhdan, Funkhouser, Rusinkiewicz 2003): a function of space,
/// restricted to spheres about the surface's centroid, and of each sphere the norms by frequency; weighted by the
/// sphere's radius, so that L2 compares volumes. The function is the Gaussian of the distance to the surface, by which
/// the Princeton Shape Benchmark judges the descriptor, or the surface as voxels.
///
/// Scale and place do not matter; a mesh's orientation, closedness and connectivity neither; clouds are described by
/// their points. Throws InputError for options out of range, an unusable shape, and one without extent or area.
Eigen::VectorXf spherical_harmonics(const Shape& shape, const SphericalHarmonicsOptions& options = {});

Descriptor spherical_harmonics_descriptor();

}  // namespace shapegauge
