#pragma once

#include "shapegauge/core/preparation/noise_level.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// A shape after denoised(), and what was found.
struct DenoisedShape {
  Shape shape;
  NoiseLevel noise;      ///< of the shape given
  double pass_band = 0;  ///< of the smoothing (see taubin_smoothed); 0: none, the shape is as given
};

/// Takes the noise out of a mesh whose vertices are noisy beyond doubt (is_noisy), and leaves any other shape as it is.
///
/// The vertices are smoothed with a pass band of 0.025 / noise.relative(), between 0.02 and 0.3; what comes of it is
/// in docs/figures.md, Fig 6. Clouds have no neighbours to smooth with and stay.
DenoisedShape denoised(Shape shape);

}  // namespace shapegauge
