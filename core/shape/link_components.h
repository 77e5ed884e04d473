// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Undirected segment between two points: the indices a and b of its ends, and its length.
struct Segment {
  std::int32_t a;
  std::int32_t b;
  double length;
};

/// Returns the segments from each point to its `neighbours` nearest neighbours.
std::vector<Segment> nearest_segments(const Points& points, Eigen::Index neighbours);

/// Connects the components of a graph by adding segments until one component is left. First adds segments between
/// points of different components that are among each other's nearest neighbours. Then connects each remaining
/// component to the nearest other one (nearest among 64 points of each; Boruvka's algorithm). Returns the initial
/// number of components.
std::int32_t link_components(const Points& points, Eigen::Index neighbours, std::vector<Segment>& segments);

}  // namespace shapegauge
