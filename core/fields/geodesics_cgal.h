#pragma once

#include "shapegauge/core/fields/geodesics.h"

namespace shapegauge {

/// The methods of CGAL: heat and exact. `shape` has no two used vertices at the same place, and is usable. Throws
/// InputError as geodesic_distances().
GeodesicDistances geodesic_distances_cgal(const Shape& shape, GeodesicMethod method);

}  // namespace shapegauge
