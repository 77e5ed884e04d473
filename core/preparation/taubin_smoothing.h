#pragma once

#include "shapegauge/core/preparation/vertex_neighbours.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Low-pass filter of a mesh's vertices without shrinkage: steps towards the mean of the neighbours alternate with
/// slightly larger steps away from it (Taubin 1995, "A signal processing approach to fair surface design").
///
/// pass_band, Taubin's k_PB in (0, 1): what varies along the mesh with a frequency k (0: constant, 2: from vertex to
/// vertex) is kept for k < pass_band and fades beyond; a wave of n edges has k of about (pi / n)^2. The number of
/// steps follows from it. Vertices without neighbours stay.
Points taubin_smoothed(const Points& vertices, const VertexNeighbours& neighbours, double pass_band);

}  // namespace shapegauge
