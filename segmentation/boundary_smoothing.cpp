// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/segmentation/boundary_smoothing.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <queue>
#include <set>
#include <string>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/interruption.h"
#include "shapegauge/segmentation/alpha_expansion.h"

namespace shapegauge {

namespace {

/// For each node near a border: distances, in units, to the other parts near it.
using WaysToParts = std::vector<std::map<std::int32_t, double>>;

/// Follows the links outwards from a part's border, up to the width.
void add_ways(WaysToParts& ways, const ThickSurface& surface, std::span<const std::int32_t> labels,
              const std::vector<std::int32_t>& border, double width) {
  using Reached = std::pair<double, std::int32_t>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
  for (const std::int32_t node : border) queue.emplace(0, node);
  const std::int32_t label = labels[static_cast<std::size_t>(border.front())];
  const SparseInterruptionCheck check;
  while (!queue.empty()) {
    check();
    const auto [way, node] = queue.top();
    queue.pop();
    const bool is_start = labels[static_cast<std::size_t>(node)] == label;
    if (!is_start && ways[static_cast<std::size_t>(node)].at(label) < way) continue;
    for (const SurfaceLink& link : surface.graph.links_of(node)) {
      const double next = way + link.distance / surface.unit;
      if (next > width || labels[static_cast<std::size_t>(link.to)] == label) continue;
      auto [known, is_new] = ways[static_cast<std::size_t>(link.to)].emplace(label, next);
      if (!is_new && known->second <= next) continue;
      known->second = next;
      queue.emplace(next, link.to);
    }
  }
}

WaysToParts ways_to_parts(const ThickSurface& surface, std::span<const std::int32_t> labels, double width) {
  std::map<std::int32_t, std::vector<std::int32_t>> borders;
  for (std::int32_t i = 0; i < surface.graph.size(); ++i) {
    const std::int32_t label = labels[static_cast<std::size_t>(i)];
    const auto leaves = [&](const SurfaceLink& link) { return labels[static_cast<std::size_t>(link.to)] != label; };
    if (std::ranges::any_of(surface.graph.links_of(i), leaves)) borders[label].push_back(i);
  }
  WaysToParts ways(labels.size());
  for (const auto& [label, border] : borders) add_ways(ways, surface, labels, border, width);
  return ways;
}

/// Nodes that may change, with their labelling problem.
struct Band {
  std::vector<std::int32_t> nodes;
  std::vector<std::int32_t> index_of;  ///< per node of the surface: index in `nodes`; -1: not in the band
  std::vector<std::int32_t> labels;    ///< admissible labels, ascending; `start` and the columns of `costs` refer to it
  Eigen::MatrixXd costs;
  std::vector<LabelEdge> edges;
  std::vector<std::int32_t> start;
};

double border_cost(const ThickSurface& surface, std::int32_t node, const SurfaceLink& link,
                   const BoundarySmoothingOptions& options) {
  const double length = link.length / surface.unit;
  const double distance = std::max(link.distance / surface.unit, 1e-12);
  const double curvature = std::max(0.0, surface.normal_angle(node, link)) / distance;
  return options.strength * length / (1 + curvature / options.concavity);
}

/// Returns the nodes of the band and their admissible labels.
Band empty_band(std::span<const std::int32_t> labels, const WaysToParts& ways) {
  Band band;
  band.index_of.assign(labels.size(), -1);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (ways[i].empty()) continue;
    band.index_of[i] = static_cast<std::int32_t>(band.nodes.size());
    band.nodes.push_back(static_cast<std::int32_t>(i));
    band.labels.push_back(labels[i]);
    for (const auto& [label, way] : ways[i]) band.labels.push_back(label);
  }
  std::ranges::sort(band.labels);
  band.labels.erase(std::unique(band.labels.begin(), band.labels.end()), band.labels.end());
  return band;
}

Band band_of(const ThickSurface& surface, std::span<const std::int32_t> labels, const WaysToParts& ways,
             const BoundarySmoothingOptions& options) {
  Band band = empty_band(labels, ways);
  const auto column_of = [&](std::int32_t label) {
    return static_cast<std::int32_t>(std::ranges::lower_bound(band.labels, label) - band.labels.begin());
  };
  // A label out of reach costs more than all borders together.
  const double out_of_reach = 10;
  band.costs = Eigen::MatrixXd::Constant(std::ssize(band.nodes), std::ssize(band.labels), out_of_reach);
  const double whole = surface.unit * surface.unit;
  for (std::size_t k = 0; k < band.nodes.size(); ++k) {
    const std::int32_t node = band.nodes[k];
    const auto row = static_cast<Eigen::Index>(k);
    band.start.push_back(column_of(labels[static_cast<std::size_t>(node)]));
    band.costs(row, band.start.back()) = 0;
    for (const auto& [label, way] : ways[static_cast<std::size_t>(node)]) {
      band.costs(row, column_of(label)) = surface.graph.samples.weights[node] / whole * way / options.width;
    }
    for (const SurfaceLink& link : surface.graph.links_of(node)) {
      const std::int32_t other = band.index_of[static_cast<std::size_t>(link.to)];
      const double cost = border_cost(surface, node, link, options);
      if (other > static_cast<std::int32_t>(k)) band.edges.push_back({static_cast<std::int32_t>(k), other, cost});
      if (other >= 0) continue;
      // The neighbour keeps its label: every other label has the cost of the border.
      band.costs.row(row).array() += cost;
      const std::int32_t fixed_label = labels[static_cast<std::size_t>(link.to)];
      if (std::ranges::binary_search(band.labels, fixed_label)) band.costs(row, column_of(fixed_label)) -= cost;
    }
  }
  return band;
}

}  // namespace

std::vector<std::int32_t> smooth_boundaries(const ThickSurface& surface, std::span<const std::int32_t> labels,
                                            const BoundarySmoothingOptions& options) {
  check_options("smoothing of boundaries", boundary_smoothing_table, options);
  if (std::ssize(labels) != surface.graph.size()) {
    throw ArgumentError("there are " + std::to_string(labels.size()) + " labels for the " +
                        std::to_string(surface.graph.size()) + " nodes of the surface");
  }
  if (std::ranges::any_of(labels, [](std::int32_t label) { return label < 0; })) {
    throw ArgumentError("a label of the surface is negative; labels are numbered from 0");
  }
  std::vector<std::int32_t> result(labels.begin(), labels.end());
  const WaysToParts ways = ways_to_parts(surface, labels, options.width);
  if (std::ranges::all_of(ways, [](const auto& way) { return way.empty(); })) return result;
  const Band band = band_of(surface, labels, ways, options);
  const std::vector<std::int32_t> smooth = alpha_expansion(band.costs, band.edges, band.start);
  for (std::size_t k = 0; k < smooth.size(); ++k) {
    result[static_cast<std::size_t>(band.nodes[k])] = band.labels[static_cast<std::size_t>(smooth[k])];
  }
  // A part that would disappear keeps its nodes.
  const std::set<std::int32_t> left(result.begin(), result.end());
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (!left.contains(labels[i])) result[i] = labels[i];
  }
  return result;
}

}  // namespace shapegauge
