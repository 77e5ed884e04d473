#pragma once

#include "shapegauge/core/preparation/denoise.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Computes the surface area, or the sum of point_weights() of a cloud, in the shape's units squared. Throws InputError
/// if it is zero or not finite, and for an unusable shape (require_usable()).
double positive_area(const Shape& shape);

/// Cache version of prepare_shape(); see docs/manual/cache.md.
inline constexpr int preparation_version = 2;

/// Quantity that normalises the scale of a shape.
enum class ScaleEstimate {
  area,       ///< unit positive_area(): exact on clean meshes, meaningless with noise or holes
  tube_area,  ///< unit tube_area(): robust to noise, cracks and sampling
};

/// Options of prepare_shape().
struct PreparationOptions {
  bool denoise = false;  ///< see denoised()
  ScaleEstimate scale = ScaleEstimate::area;
};

/// Normalised shape and the quantities estimated for it.
struct PreparedShape {
  Shape shape;
  NoiseLevel noise;      ///< of the input; only with `denoise`
  double pass_band = 0;  ///< of the smoothing; 0 if not smoothed
  double area = 0;       ///< the area that was scaled to 1, in the input's units squared
};

/// Denoises the shape if requested and scales it about the origin to unit area. Throws InputError as positive_area()
/// and tube_area() do, and for an unusable shape (require_usable()).
PreparedShape prepare_shape(Shape shape, const PreparationOptions& options);

}  // namespace shapegauge
