// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Draws the silhouette of triangles, rotated and projected along z, as pixels x pixels bytes in rows. A pixel is 1 if
/// a triangle covers its centre or a vertex lies in it, which preserves thin parts; otherwise 0. The image is the
/// square [-1, 1]^2. Vertices are rounded to 1/256 of a pixel, and those outside are moved to the border. `vertices`
/// has one column per vertex; all of them are drawn.
std::vector<std::uint8_t> silhouette(const Eigen::Matrix3Xf& vertices, const Triangles& triangles,
                                     const Eigen::Matrix3d& rotation, int pixels);

/// Number of Zernike moments in SilhouetteFeatures: those up to order 10, without the area (order 0).
inline constexpr std::size_t zernike_moments = 35;
/// Number of Fourier coefficients of the outline in SilhouetteFeatures: coefficients 1 to 10.
inline constexpr std::size_t outline_coefficients = 10;
/// Number of features of a silhouette: Zernike moments, followed by Fourier coefficients.
inline constexpr std::size_t silhouette_feature_count = zernike_moments + outline_coefficients;

/// Computes features of silhouettes that are invariant to rotation and reflection of the image: magnitudes of
/// - Zernike moments of the disc that touches the image's sides, by order and then repetition (Khotanzad and Hong
///   1990).
/// - Fourier coefficients, divided by the zeroth, of the distances of the outline from its centroid (Zhang and Lu
///   2002). The outline is the longest of a connected component; an empty image has zeros only.
class SilhouetteFeatures {
 public:
  explicit SilhouetteFeatures(int pixels);  ///< for images of `pixels` x `pixels`

  /// Computes the features of an image of silhouette(). Throws ArgumentError for an image of another size.
  [[nodiscard]] std::array<double, silhouette_feature_count> operator()(std::span<const std::uint8_t> image) const;

 private:
  int pixels_;  ///< width and height of the images
  /// Prefix sums of the conjugate Zernike polynomials along each row of the image, real and then imaginary parts,
  /// scaled by a pixel's area and the moments' factor, zero outside the disc. The sum over a run of pixels is one
  /// difference.
  Eigen::Matrix<float, Eigen::Dynamic, 2 * zernike_moments, Eigen::RowMajor> sums_;
};

/// Returns the features object for one image size; caches it for sizes of up to 256 pixels.
std::shared_ptr<const SilhouetteFeatures> shared_silhouette_features(int pixels);

}  // namespace shapegauge
