// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "shapegauge/core/base/option_parameters.h"
#include "shapegauge/core/preparation/denoise.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Computes the surface area, or the sum of point_weights() of a cloud, in the shape's units squared. Throws InputError
/// if it is zero or not finite, and for an unusable shape (require_usable()).
double positive_area(const Shape& shape);

/// Cache version of prepare_shape(); see docs/manual/cache.md.
inline constexpr int preparation_version = 4;

/// Measure of area by which the scale of a shape is normalised.
enum class ScaleEstimate {
  area,       ///< scales positive_area() to 1: exact on clean meshes, meaningless with noise or holes
  tube_area,  ///< scales tube_area() to 1: robust to noise, cracks and sampling
};

template <>
inline constexpr std::array<std::string_view, 2> words_of<ScaleEstimate>{"area", "tube_area"};

/// Options of prepare_shape().
struct PreparationOptions {
  bool denoise = false;                       ///< smooth clearly noisy meshes (denoised())
  bool remove_outliers = false;               ///< remove the outliers of clouds (without_outliers())
  ScaleEstimate scale = ScaleEstimate::area;  ///< measure of area that is scaled to 1

  bool operator==(const PreparationOptions&) const = default;
};

/// Names, bounds and help texts of the parameters in PreparationOptions (option_parameters.h).
inline constexpr std::array preparation_table = {
    option_of<&PreparationOptions::denoise>(
        "denoise", "Smooth clearly noisy meshes, in proportion to their noise; other shapes are unchanged."),
    option_of<&PreparationOptions::remove_outliers>(
        "remove_outliers", "Remove isolated points of clouds, more than 10 point spacings from their neighbours."),
    option_of<&PreparationOptions::scale>(
        "scale",
        "Area that is scaled to 1. area: surface area (clouds: estimated); tube_area: estimate from the volume of a "
        "tube about the surface, robust to noise, cracks and sampling."),
};

/// Result of prepare_shape(): the normalised shape and quantities estimated for it.
struct PreparedShape {
  Shape shape;           ///< cleaned shape, with an area (PreparationOptions::scale) of 1
  NoiseLevel noise;      ///< noise of the input shape; 0 without the option `denoise`
  double pass_band = 0;  ///< pass band of the smoothing (taubin_smoothing()); 0 if not smoothed
  double area = 0;       ///< area that was scaled to 1, after cleaning, in the input's units squared
};

/// Removes normals that are not those of the surface (remove_stray_normals()) and, if requested, outliers and noise.
/// Scales the shape about the origin to unit area. Throws InputError as positive_area() and tube_area() do, and for an
/// unusable shape (require_usable()).
PreparedShape prepare_shape(Shape shape, const PreparationOptions& options);

}  // namespace shapegauge
