#pragma once

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Whether two triangles of a manifold mesh meet elsewhere than at a vertex or an edge that they share (CGAL, exact).
bool self_intersects(const Shape& mesh);

}  // namespace shapegauge
