#pragma once

#include "shapegauge/core/shape/shape.h"
#include "shapegauge/random/random_numbers.h"

namespace shapegauge {

/// The mesh without exactly round(fraction * n) of its n faces, chosen at random; a cloud without as many of its
/// points. The vertices of a mesh all stay, so that indices keep their meaning. Throws InputError unless the fraction
/// is in [0, 1] and something is left.
Shape remove_faces(Shape shape, double fraction, RandomNumbers& random);

}  // namespace shapegauge
