// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Undirected segment between two of a set of points: an edge of a graph whose nodes are the points.
struct Segment {
  std::int32_t a;  ///< index of the point at one end
  std::int32_t b;  ///< index of the point at the other end
  double length;   ///< length in the units of the points
};

/// Returns the segments from each point to its `neighbours` nearest neighbours; a segment occurs twice if each of its
/// ends is among the nearest neighbours of the other.
std::vector<Segment> nearest_segments(const Points& points, Eigen::Index neighbours);

/// Connects the components of a graph (nodes: `points`, edges: `segments`) by adding segments until one component is
/// left. First adds the segments from each point to those of its `neighbours` nearest neighbours that belong to other
/// components. Then connects each remaining component to the nearest other one (nearest among up to 64 points of each;
/// Boruvka's algorithm). Returns the initial number of components.
std::int32_t link_components(const Points& points, Eigen::Index neighbours, std::vector<Segment>& segments);

}  // namespace shapegauge
