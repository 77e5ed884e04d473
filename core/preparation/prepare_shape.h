#pragma once

#include "shapegauge/core/preparation/denoise.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// The surface area, or the sum of a point cloud's point_weights(), in the shape's units squared. Throws InputError
/// where it is zero or not finite, and for an unusable shape (require_usable()).
double positive_area(const Shape& shape);

/// Raised with every change of what prepare_shape() makes of a shape, which makes cached results of earlier versions
/// stale.
inline constexpr int preparation_version = 2;

/// What a shape is scaled by before it is compared with others.
enum class ScaleEstimate {
  area,       ///< unit positive_area(): exact on clean meshes, meaningless under noise and holes
  tube_area,  ///< unit tube_area(): holds under noise, cracks and sampling
};

/// What happens to a shape before it is measured.
struct PreparationOptions {
  bool denoise = false;  ///< see denoised()
  ScaleEstimate scale = ScaleEstimate::area;
};

/// A shape that is ready to be measured, and what was found on the way.
struct PreparedShape {
  Shape shape;
  NoiseLevel noise;      ///< of the shape given; with denoise only
  double pass_band = 0;  ///< of the smoothing; 0: none
  double area = 0;       ///< what was scaled to 1, in units of the shape given, squared
};

/// Removes noise, if so wanted, and scales the shape about the origin to unit area. Throws InputError as
/// positive_area() and tube_area() do, and for an unusable shape (require_usable()).
PreparedShape prepare_shape(Shape shape, const PreparationOptions& options);

}  // namespace shapegauge
