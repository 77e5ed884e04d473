#pragma once

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/random/random_numbers.h"

namespace shapegauge {

/// The shape moved at random: turned about the centre of its bounding box by a rotation uniform over all rotations,
/// scaled about it by a factor between 1 / scale and scale whose logarithm is uniform (1: not scaled), and shifted by a
/// vector uniform in the ball whose radius is the diagonal of its bounding box. A cloud's normals turn with it. Throws
/// InputError for a scale that is below 1 or not finite, and for a shape without extent.
Shape random_motion(Shape shape, double scale, RandomNumbers& random);

}  // namespace shapegauge
