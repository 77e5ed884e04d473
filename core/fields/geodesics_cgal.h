// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/core/fields/geodesics.h"

namespace shapegauge {

/// Implements geodesic_distances() for CGAL's methods, heat and exact. `shape` must be usable and have no coincident
/// used vertices. Throws InputError as geodesic_distances() does.
GeodesicDistances geodesic_distances_cgal(const Shape& shape, GeodesicMethod method);

}  // namespace shapegauge
