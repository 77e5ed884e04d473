// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/shape/link_components.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <tuple>

#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/point_cloud.h"

namespace shapegauge {

namespace {

/// Returns the segments from each point to those nearest neighbours for which `condition(a, b)` holds.
template <typename Condition>
std::vector<Segment> segments_where(const Points& points, Eigen::Index neighbours, Condition condition) {
  const PointNeighbours nearest = nearest_neighbours(points, neighbours);
  std::vector<Segment> segments;
  for (Eigen::Index i = 0; i < nearest.indices.rows(); ++i) {
    for (Eigen::Index k = 0; k < nearest.indices.cols(); ++k) {
      const auto a = static_cast<std::int32_t>(i);
      const std::int32_t b = nearest.indices(i, k);
      if (condition(a, b)) segments.push_back({a, b, nearest.distances(i, k)});
    }
  }
  return segments;
}

DisjointSets components_of(std::size_t nodes, std::span<const Segment> segments) {
  DisjointSets components;
  components.grow_to(nodes);
  for (const Segment& segment : segments) components.join(segment.a, segment.b);
  return components;
}

/// Returns up to 64 nodes of each component, evenly spread over the order of its nodes.
std::vector<std::int32_t> probes_of(DisjointSets& components) {
  constexpr std::size_t most = 64;
  std::vector<std::vector<std::int32_t>> members(components.size());
  for (std::size_t i = 0; i < components.size(); ++i) {
    const auto node = static_cast<std::int32_t>(i);
    members[static_cast<std::size_t>(components.find(node))].push_back(node);
  }
  std::vector<std::int32_t> probes;
  for (const auto& component : members) {
    const std::size_t count = std::min(most, component.size());
    for (std::size_t k = 0; k < count; ++k) probes.push_back(component[k * component.size() / count]);
  }
  return probes;
}

/// Joins components by Boruvka's algorithm: adds the shortest segment from each component to another one, until one is
/// left. With 64 probes a component, the 64 nearest others of a probe always include one of another component.
void join_components(const Points& points, DisjointSets& components, std::vector<Segment>& segments) {
  for (;;) {
    const std::vector<std::int32_t> probes = probes_of(components);
    std::vector<Segment> between = segments_where(points(probes, Eigen::all), 64, [&](std::int32_t a, std::int32_t b) {
      return components.find(probes[static_cast<std::size_t>(a)]) !=
             components.find(probes[static_cast<std::size_t>(b)]);
    });
    if (between.empty()) return;
    std::ranges::sort(between, {}, [](const Segment& s) { return std::tuple(s.length, s.a, s.b); });
    std::vector<char> has_joined(components.size(), 0);
    DisjointSets before = components;
    for (const Segment& segment : between) {
      const std::int32_t a = probes[static_cast<std::size_t>(segment.a)];
      const std::int32_t b = probes[static_cast<std::size_t>(segment.b)];
      char& of_a = has_joined[static_cast<std::size_t>(before.find(a))];
      char& of_b = has_joined[static_cast<std::size_t>(before.find(b))];
      if ((of_a != 0 && of_b != 0) || components.find(a) == components.find(b)) continue;
      of_a = of_b = 1;
      components.join(a, b);
      segments.push_back({a, b, segment.length});
    }
  }
}

}  // namespace

std::vector<Segment> nearest_segments(const Points& points, Eigen::Index neighbours) {
  return segments_where(points, neighbours, [](std::int32_t, std::int32_t) { return true; });
}

std::int32_t link_components(const Points& points, Eigen::Index neighbours, std::vector<Segment>& segments) {
  DisjointSets components = components_of(static_cast<std::size_t>(points.rows()), segments);
  std::int32_t count = 0;
  for (std::int32_t i = 0; i < points.rows(); ++i) count += components.find(i) == i ? 1 : 0;
  if (count < 2) return count;
  const std::vector<Segment> across_gaps = segments_where(
      points, neighbours, [&](std::int32_t a, std::int32_t b) { return components.find(a) != components.find(b); });
  for (const Segment& segment : across_gaps) components.join(segment.a, segment.b);
  segments.insert(segments.end(), across_gaps.begin(), across_gaps.end());
  join_components(points, components, segments);
  return count;
}

}  // namespace shapegauge
