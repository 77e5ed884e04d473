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

/// Draws the silhouette of triangles, rotated and seen along z, as pixels x pixels bytes in rows: 1 where a triangle
/// covers a pixel's centre or a vertex lies in it, so that thin parts leave a trace; 0 elsewhere. The image is the
/// square from -1 to 1; vertices are rounded to 1/256 of a pixel, and those outside are moved to its border.
/// - vertices: a column each; all of them are drawn
std::vector<std::uint8_t> silhouette(const Eigen::Matrix3Xf& vertices, const Triangles& triangles,
                                     const Eigen::Matrix3d& rotation, int pixels);

/// Magnitudes of Zernike moments up to order 10 without the area.
inline constexpr std::size_t zernike_moments = 35;
/// Magnitudes of the outline's Fourier coefficients 1 to 10.
inline constexpr std::size_t outline_coefficients = 10;
inline constexpr std::size_t silhouette_feature_count = zernike_moments + outline_coefficients;

/// Features of silhouettes of one size, which turning and mirroring the image do not change: Zernike moments of the
/// disc that touches the image's sides, by order and then repetition (Khotanzad and Hong 1990), and Fourier
/// coefficients, over the zeroth, of the distances of the outline from its centroid (Zhang and Lu 2002). The outline is
/// the longest around a connected part; an empty image has only zeros.
class SilhouetteFeatures {
 public:
  explicit SilhouetteFeatures(int pixels);

  [[nodiscard]] std::array<double, silhouette_feature_count> operator()(std::span<const std::uint8_t> image) const;

 private:
  int pixels_;
  /// Sums, along each row of the image, of the conjugate basis over the pixels before: real and then imaginary parts,
  /// with the area of a pixel and the moments' factor; nothing outside the disc. A run of pixels is one difference.
  Eigen::Matrix<float, Eigen::Dynamic, 2 * zernike_moments, Eigen::RowMajor> sums_;
};

/// Returns the features of images of one size, which take a while to prepare; those of up to 256 pixels are kept.
std::shared_ptr<const SilhouetteFeatures> shared_silhouette_features(int pixels);

}  // namespace shapegauge
