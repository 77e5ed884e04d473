#pragma once

#include "shapegauge/core/preparation/vertex_neighbours.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// How noisy the vertices of a mesh are.
struct NoiseLevel {
  double deviation = 0;    ///< what neighbours do not share along the normal, as a standard deviation, in shape units
  double edge_length = 0;  ///< mean edge length of the smoothed mesh
  /// Share of edges whose ends lie on the same side of the smoothed mesh: about 0.46 where heights are independent,
  /// 0.6 and more where they are form (ridges, creases, coarse curved parts).
  double agreement = 1;

  /// deviation / edge_length; 0.02 to 0.05 on clean, fine meshes.
  [[nodiscard]] double relative() const { return edge_length > 0 ? deviation / edge_length : 0; }
};

/// Estimates the noise of a mesh: what moves its vertices along the normal independently of one another.
///
/// Each vertex' height above the smoothed mesh, less the mean height of its neighbours, is taken; the median of its
/// size tells the standard deviation, so that what varies slowly and what is rare drop out. On coarse meshes form
/// passes for deviation too; `agreement` tells the two apart. The orientation of triangles plays no part. All zero for
/// a cloud.
NoiseLevel noise_level(const Shape& shape, const VertexNeighbours& neighbours);

/// Whether the vertices are noisy beyond doubt: at least 500 of them (those at the same place
/// counted once, those of no triangle not at all), a relative() of 0.1 or more, and an agreement
/// that form does not have (below 0.56).
bool is_noisy(const NoiseLevel& noise, const VertexNeighbours& neighbours);

}  // namespace shapegauge
