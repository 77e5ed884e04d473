#pragma once

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/random/random_numbers.h"

namespace shapegauge {

/// How a random displacement is distributed.
enum class NoiseDistribution {
  gaussian,  ///< each coordinate has the amplitude as its standard deviation
  uniform    ///< uniform in the ball whose radius is the amplitude
};

struct VertexNoiseOptions {
  double amplitude = 0.005;  ///< as a fraction of the bounding box's diagonal; at least 0
  NoiseDistribution distribution = NoiseDistribution::uniform;
};

/// The shape with every vertex (or point of a cloud) moved by a random vector of its own. Vertices are told apart by
/// index: those at the same place that are not one vertex part, and a soup comes apart. A cloud's normals stay. Throws
/// InputError for an amplitude that is negative or not finite, and for a shape without extent.
Shape vertex_noise(Shape shape, const VertexNoiseOptions& options, RandomNumbers& random);

}  // namespace shapegauge
