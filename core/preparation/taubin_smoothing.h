#pragma once

#include "shapegauge/core/preparation/vertex_neighbours.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Low-pass filter of a mesh's vertices without shrinkage: steps towards the mean of the neighbours alternate with
/// slightly larger steps away from it (Taubin 1995, "A signal processing approach to fair surface design").
///
/// pass_band, Taubin's k_PB in (0, 1): what varies along the mesh with a frequency k (0: constant; 3/2 and more: from
/// vertex to vertex) is multiplied by ((1 - k / 2) (1 + k / (2 - pass_band)))^N, with N = ceil(2 / pass_band) + 3
/// rounds: kept for k < pass_band (to within 2 % where pass_band is at most 0.1), faded beyond. A wave of n edges has k
/// of about (pi / n)^2. Vertices without neighbours stay.
///
/// Throws InputError for a pass band out of range.
Points taubin_smoothed(const Points& vertices, const VertexNeighbours& neighbours, double pass_band);

}  // namespace shapegauge
