#pragma once

#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// A segment between two points, which paths may take either way.
struct Segment {
  std::int32_t a;
  std::int32_t b;
  double length;
};

/// The segments from each of the points to its nearest neighbours.
std::vector<Segment> nearest_segments(const Points& points, Eigen::Index neighbours);

/// Adds segments between the components of a graph until it has only one: between points of different components that
/// are among each other's nearest neighbours first, then from each remaining component to the nearest of the others
/// (nearest among 64 points of each; Boruvka's algorithm). Returns the number of components that there were.
std::int32_t link_components(const Points& points, Eigen::Index neighbours, std::vector<Segment>& segments);

}  // namespace shapegauge
