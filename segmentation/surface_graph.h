#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// The way from one node of a surface graph to a neighbour. Every link has its reverse.
struct SurfaceLink {
  std::int32_t to = 0;
  double length = 0;     ///< of what the two share: an edge; of points of a cloud, the width of a point's area
  double distance = 0;   ///< between the nodes along the surface: over the middle of the common edge
  double concavity = 0;  ///< the angle between the normals in radians; below 0 where the surface is convex
};

/// The triangles of a mesh, or the points of a cloud, and who is next to whom: what segmentation works on. Nodes are
/// numbered as the shape's triangles or points.
struct SurfaceGraph {
  Samples samples;                 ///< of the nodes: at the triangles' centroids, or the points of the cloud
  std::vector<std::size_t> first;  ///< by node, where its links begin; one more entry at the end
  std::vector<SurfaceLink> links;  ///< those of a node by increasing neighbour

  [[nodiscard]] std::int32_t size() const { return static_cast<std::int32_t>(samples.points.rows()); }

  [[nodiscard]] std::span<const SurfaceLink> links_of(std::int32_t node) const {
    const auto n = static_cast<std::size_t>(node);
    return std::span(links).subspan(first[n], first[n + 1] - first[n]);
  }
};

/// The graph of a shape. Triangles are neighbours where they share an edge, vertices at the same place taken as one; of
/// an edge of more than two triangles, each of them is the neighbour of the next one in the shape's order. Where edges
/// of a single triangle meet at a vertex, as around a gap, their triangles are neighbours too. Points of a cloud are
/// neighbours where one is among the 8 nearest of the other.
///
/// Concavity takes the normals' side as the outside. Two triangles that are not oriented alike are compared as if they
/// were. Throws InputError for an empty shape and where it is unusable (require_usable()).
SurfaceGraph surface_graph(const Shape& shape);

}  // namespace shapegauge
