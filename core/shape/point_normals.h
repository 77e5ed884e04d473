#pragma once

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// For each point of a cloud the direction along which it and its 12 nearest neighbours spread the least, a unit vector
/// of either sign: the normal of the surface that they lie on, but for its side (Hoppe et al. 1992). Zero where the
/// neighbours are all at one place. Runs in the calling TBB arena.
Points unsigned_point_normals(const Points& points);

}  // namespace shapegauge
