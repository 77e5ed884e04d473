// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Link from one node of a surface graph to a neighbour. Every link has its reverse.
struct SurfaceLink {
  std::int32_t to = 0;  ///< index of the neighbouring node
  /// Length of the triangles' common edge; across a gap, half the shorter boundary edge; in a cloud, the mean square
  /// root of the two points' areas.
  double length = 0;
  double distance = 0;   ///< length of the path between the nodes across the middle of the edge, or the gap's vertex
  double concavity = 0;  ///< angle between the normals of the two nodes, in radians; positive if the surface is concave
};

/// Adjacency graph of the triangles of a mesh, or the points of a cloud, for segmentation. Nodes are numbered as the
/// shape's triangles or points.
struct SurfaceGraph {
  Samples samples;  ///< position, normal and area of each node: centroids of triangles or points of a cloud
  std::vector<std::size_t> first;  ///< per node: index of its first link in `links`; last entry: number of links
  std::vector<SurfaceLink> links;  ///< links of all nodes, sorted by node and then by neighbour

  /// Returns the number of nodes.
  [[nodiscard]] std::int32_t size() const { return static_cast<std::int32_t>(samples.points.rows()); }

  /// Returns the links of a node to its neighbours.
  [[nodiscard]] std::span<const SurfaceLink> links_of(std::int32_t node) const {
    const auto n = static_cast<std::size_t>(node);
    return std::span(links).subspan(first[n], first[n + 1] - first[n]);
  }
};

/// Builds the graph of a shape. Triangles are adjacent if they share an edge, with coincident vertices welded. At an
/// edge of more than two triangles, consecutive triangles in the shape's order are adjacent. Triangles whose boundary
/// edges meet at a vertex, as around a gap, are adjacent as well. Points of a cloud are adjacent if one is among the 8
/// nearest of the other.
///
/// Concavity assumes that normals point outwards. Two triangles of opposite orientations are compared as if they were
/// oriented consistently. Throws InputError for an empty or unusable shape (require_usable()).
SurfaceGraph surface_graph(const Shape& shape);

}  // namespace shapegauge
