// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "shapegauge/segmentation/regions.h"
#include "shapegauge/segmentation/thick_surface.h"

namespace shapegauge::test {

/// An edge of a hand-made surface: its two nodes and its length.
struct HandMadeLink {
  std::int32_t a;
  std::int32_t b;
  double length;
  double distance = 1;
  double concavity = 0;
};

/// A graph of nodes of these areas, with these links in both directions. Nodes are at 0, 1, 2, ... along x; normals are
/// along z.
inline SurfaceGraph hand_made_graph(const std::vector<double>& areas, const std::vector<HandMadeLink>& links) {
  SurfaceGraph graph;
  const std::ptrdiff_t count = std::ssize(areas);
  graph.samples.points = Points::Zero(count, 3);
  graph.samples.points.col(0) = Eigen::VectorXd::LinSpaced(count, 0, static_cast<double>(count - 1));
  graph.samples.normals = Points::Zero(count, 3);
  graph.samples.normals.col(2).setOnes();
  graph.samples.weights = Eigen::Map<const Eigen::VectorXd>(areas.data(), count);
  for (std::int32_t node = 0; node < count; ++node) {
    graph.first.push_back(graph.links.size());
    for (const HandMadeLink& link : links) {
      if (link.a != node && link.b != node) continue;
      const std::int32_t other = link.a == node ? link.b : link.a;
      graph.links.push_back({other, link.length, link.distance, link.concavity});
    }
  }
  graph.first.push_back(graph.links.size());
  return graph;
}

/// Links from each node to the next, with equal distances.
inline std::vector<HandMadeLink> chain(const std::vector<double>& lengths, double distance = 1) {
  std::vector<HandMadeLink> links;
  for (const double length : lengths) {
    const auto a = static_cast<std::int32_t>(links.size());
    links.push_back({.a = a, .b = a + 1, .length = length, .distance = distance});
  }
  return links;
}

/// Flat surface of the graph with constant thickness, without obstacles for rays.
inline ThickSurface hand_made_surface(SurfaceGraph graph, double unit) {
  ThickSurface surface;
  surface.smooth_normals = graph.samples.normals;
  surface.log_thickness = Eigen::VectorXd::Constant(graph.size(), -2);
  surface.unit = unit;
  surface.graph = std::move(graph);
  return surface;
}

/// Regions of one node each, in a row.
inline Regions regions_in_a_row(std::int32_t count) {
  Regions regions(count);
  for (std::int32_t i = 0; i < count; ++i) {
    RegionSum sum;
    sum.nodes = 1;
    sum.area = i + 1;
    regions.add(i, sum);
    if (i == 0) continue;
    regions.make_neighbours(i - 1, i);
    regions.add(i - 1, i, PairSum::border, 1 << i);
  }
  return regions;
}

}  // namespace shapegauge::test
