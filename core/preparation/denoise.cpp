#include "shapegauge/core/preparation/denoise.h"

#include <algorithm>
#include <utility>

#include "shapegauge/core/preparation/taubin_smoothing.h"

namespace shapegauge {

DenoisedShape denoised(Shape shape) {
  const VertexNeighbours neighbours = vertex_neighbours(shape);
  const NoiseLevel noise = noise_level(shape, neighbours);
  DenoisedShape result{.shape = std::move(shape), .noise = noise};
  if (!is_noisy(noise, neighbours)) return result;
  result.pass_band = std::clamp(0.025 / noise.relative(), 0.02, 0.3);
  result.shape.vertices = taubin_smoothed(result.shape.vertices, neighbours, result.pass_band);
  return result;
}

}  // namespace shapegauge
