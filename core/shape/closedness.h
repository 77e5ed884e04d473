#pragma once

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Whether the triangles separate an inside from an outside by parity: every edge belongs to an even number of
/// triangles, vertices at the same place taken as one and triangles of no area left out. Orientation plays no part. A
/// shape without triangles is not closed. Throws InputError where the shape is unusable (validity.h).
bool is_closed(const Shape& shape);

/// Whether the triangles are oriented alike besides: every edge is run through as often one way as the other. Then, of
/// any ray from outside, as many crossings lead in as out, however parts overlap.
bool is_closed_and_oriented(const Shape& shape);

}  // namespace shapegauge
