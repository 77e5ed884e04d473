#pragma once

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/random/random_numbers.h"

namespace shapegauge {

/// The mesh with exactly round(fraction * n) of its n faces, chosen at random, turned over (1: all of them); a cloud
/// with as many of its normals reversed, where it has any. Throws InputError unless the fraction is in [0, 1].
Shape flip_orientation(Shape shape, double fraction, RandomNumbers& random);

}  // namespace shapegauge
