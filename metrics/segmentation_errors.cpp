// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/metrics/segmentation_errors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// Overlap of a segment of one segmentation with a segment of the other.
struct Overlap {
  std::int32_t label;
  std::int32_t truth;
  double weight;
};

/// Contingency table: the weight of the elements with each pair of labels.
struct ContingencyTable {
  std::vector<Overlap> overlaps;  ///< sorted by label, then by truth; each pair once
  double total = 0;
  double squares = 0;  ///< sum of the elements' squared weights
};

void check_sizes(std::span<const std::int32_t> labels, std::span<const std::int32_t> truth) {
  if (labels.size() == truth.size()) return;
  throw ArgumentError("the segmentations have " + std::to_string(labels.size()) + " and " +
                      std::to_string(truth.size()) + " labels; expected one per triangle in both");
}

ContingencyTable contingency_table(std::span<const std::int32_t> labels, std::span<const std::int32_t> truth,
                                   std::span<const double> weights) {
  if (labels.empty()) throw ArgumentError("a segmentation needs the labels of at least one triangle");
  check_sizes(labels, truth);
  if (!weights.empty() && weights.size() != labels.size()) {
    throw ArgumentError("there are " + std::to_string(weights.size()) + " weights for " +
                        std::to_string(labels.size()) + " triangles");
  }
  ContingencyTable table;
  std::vector<Overlap> elements;
  elements.reserve(labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const double weight = weights.empty() ? 1 : weights[i];
    if (!(weight >= 0 && std::isfinite(weight))) {
      throw ArgumentError("the weight of triangle " + std::to_string(i) + " is " + std::to_string(weight) +
                          "; it must be finite and at least 0");
    }
    elements.push_back({labels[i], truth[i], weight});
    table.total += weight;
    table.squares += weight * weight;
  }
  if (!(table.total > 0)) throw ArgumentError("the weights of all triangles are 0; at least one must be positive");
  const auto key = [](const Overlap& o) { return std::pair(o.label, o.truth); };
  std::ranges::stable_sort(elements, {}, key);
  for (const Overlap& element : elements) {
    if (table.overlaps.empty() || key(table.overlaps.back()) != key(element)) {
      table.overlaps.push_back(element);
    } else {
      table.overlaps.back().weight += element.weight;
    }
  }
  return table;
}

/// Exchanges the two segmentations.
ContingencyTable exchanged(ContingencyTable table) {
  for (Overlap& overlap : table.overlaps) std::swap(overlap.label, overlap.truth);
  std::ranges::sort(table.overlaps, {}, [](const Overlap& o) { return std::pair(o.label, o.truth); });
  return table;
}

/// Calls visit(std::span<const Overlap>) with the overlaps of each segment of the first segmentation.
template <typename Visit>
void for_each_segment(const ContingencyTable& table, Visit visit) {
  const std::span<const Overlap> all(table.overlaps);
  for (std::size_t begin = 0; begin < all.size();) {
    std::size_t end = begin + 1;
    while (end < all.size() && all[end].label == all[begin].label) ++end;
    visit(all.subspan(begin, end - begin));
    begin = end;
  }
}

double weight_of(std::span<const Overlap> segment) {
  double sum = 0;
  for (const Overlap& overlap : segment) sum += overlap.weight;
  return sum;
}

double sum_of_squared_segments(const ContingencyTable& table) {
  double sum = 0;
  for_each_segment(table, [&](std::span<const Overlap> segment) {
    const double weight = weight_of(segment);
    sum += weight * weight;
  });
  return sum;
}

/// Returns the share of the surface outside the largest overlap of its segment with a segment of the other
/// segmentation.
double outside_of_largest_overlaps(const ContingencyTable& table) {
  double sum = 0;
  for_each_segment(table, [&](std::span<const Overlap> segment) {
    double largest = 0;
    for (const Overlap& overlap : segment) largest = std::max(largest, overlap.weight);
    sum += weight_of(segment) - largest;
  });
  return sum / table.total;
}

/// Returns, for each overlap, the share of its segment in the first segmentation that lies outside it.
std::vector<double> refinement_errors(const ContingencyTable& table) {
  std::vector<double> errors;
  for_each_segment(table, [&](std::span<const Overlap> segment) {
    const double weight = weight_of(segment);
    for (const Overlap& overlap : segment) errors.push_back(weight > 0 ? 1 - overlap.weight / weight : 0);
  });
  return errors;
}

/// Reorders refinement errors of the exchanged table to the order of the table.
std::vector<double> in_order_of(const ContingencyTable& table, const ContingencyTable& other,
                                const std::vector<double>& errors) {
  std::vector<double> result;
  for (const Overlap& overlap : table.overlaps) {
    const auto found = std::ranges::lower_bound(other.overlaps, std::pair(overlap.truth, overlap.label), {},
                                                [](const Overlap& o) { return std::pair(o.label, o.truth); });
    result.push_back(errors[static_cast<std::size_t>(found - other.overlaps.begin())]);
  }
  return result;
}

/// Returns the length of cuts represented by each vertex; 0 away from cuts.
std::vector<double> cut_lengths(std::span<const std::int32_t> labels, const std::vector<MeshEdge>& edges,
                                std::int32_t vertices) {
  std::vector<double> lengths(static_cast<std::size_t>(vertices), 0);
  for (const MeshEdge& edge : edges) {
    const auto [a, b] = edge.triangles;
    if (b < 0 || labels[static_cast<std::size_t>(a)] == labels[static_cast<std::size_t>(b)]) continue;
    for (const std::int32_t v : edge.vertices) lengths[static_cast<std::size_t>(v)] += edge.length / 2;
  }
  return lengths;
}

/// Edges at each vertex.
struct VertexEdges {
  std::vector<std::size_t> first;
  std::vector<std::pair<std::int32_t, double>> ways;  ///< the other end, and the length
};

VertexEdges edges_by_vertex(const std::vector<MeshEdge>& edges, std::int32_t vertices) {
  VertexEdges result;
  result.first.assign(static_cast<std::size_t>(vertices) + 1, 0);
  for (const MeshEdge& edge : edges) {
    for (const std::int32_t v : edge.vertices) ++result.first[static_cast<std::size_t>(v) + 1];
  }
  for (std::size_t v = 1; v < result.first.size(); ++v) result.first[v] += result.first[v - 1];
  result.ways.resize(result.first.back());
  std::vector<std::size_t> next = result.first;
  for (const MeshEdge& edge : edges) {
    const auto [a, b] = edge.vertices;
    result.ways[next[static_cast<std::size_t>(a)]++] = {b, edge.length};
    result.ways[next[static_cast<std::size_t>(b)]++] = {a, edge.length};
  }
  return result;
}

/// Computes shortest paths along edges from each vertex to the nearest one of positive cut length (Dijkstra 1959).
std::vector<double> distances_to_cuts(const VertexEdges& edges, const std::vector<double>& cuts) {
  using Reached = std::pair<double, std::size_t>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
  std::vector<double> distances(cuts.size(), std::numeric_limits<double>::infinity());
  for (std::size_t v = 0; v < cuts.size(); ++v) {
    if (!(cuts[v] > 0)) continue;
    distances[v] = 0;
    queue.emplace(0, v);
  }
  while (!queue.empty()) {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (distance > distances[v]) continue;
    for (std::size_t i = edges.first[v]; i < edges.first[v + 1]; ++i) {
      const auto to = static_cast<std::size_t>(edges.ways[i].first);
      const double way = distance + edges.ways[i].second;
      if (!(way < distances[to])) continue;
      distances[to] = way;
      queue.emplace(way, to);
    }
  }
  return distances;
}

/// Returns the mean distance of the cuts from the other cuts; NaN without cuts or without a path.
double mean_distance(const std::vector<double>& cuts, const std::vector<double>& distances) {
  double sum = 0;
  double length = 0;
  for (std::size_t v = 0; v < cuts.size(); ++v) {
    if (!(cuts[v] > 0)) continue;
    sum += cuts[v] * distances[v];
    length += cuts[v];
  }
  return length > 0 && std::isfinite(sum) ? sum / length : undefined;
}

void check_edges(std::size_t triangles, const std::vector<MeshEdge>& edges, std::int32_t vertices) {
  const auto is_triangle = [&](std::int32_t f) { return f >= 0 && static_cast<std::size_t>(f) < triangles; };
  for (const MeshEdge& edge : edges) {
    for (const std::int32_t v : edge.vertices) {
      if (v < 0 || v >= vertices) {
        throw ArgumentError("an edge refers to vertex " + std::to_string(v) + ", but there are " +
                            std::to_string(vertices) + ", numbered from 0");
      }
    }
    if (!is_triangle(edge.triangles[0]) || (edge.triangles[1] != -1 && !is_triangle(edge.triangles[1]))) {
      throw ArgumentError("an edge refers to triangles " + std::to_string(edge.triangles[0]) + " and " +
                          std::to_string(edge.triangles[1]) + ", but there are " + std::to_string(triangles) +
                          ", numbered from 0");
    }
    if (!(edge.length >= 0 && std::isfinite(edge.length))) {
      throw ArgumentError("the length of an edge is " + std::to_string(edge.length) +
                          "; it must be finite and at least 0");
    }
  }
}

}  // namespace

const std::array<SegmentationErrorEntry, 7>& segmentation_error_entries() {
  static const std::array<SegmentationErrorEntry, 7> entries = {{
      {"Rand", "share of pairs of elements together in one segmentation and apart in the other (Rand 1971)",
       &SegmentationErrors::rand_index},
      {"CD",
       "sum of the mean distances between the cuts in both directions, in mean radii of the surface (Chen et al. 2009)",
       &SegmentationErrors::cut_discrepancy},
      {"Hamming", "mean of missing and false alarm rate (Huang and Dom 1995)", &SegmentationErrors::hamming},
      {"Missing", "share of the surface outside of the best match of each true segment (Huang and Dom 1995)",
       &SegmentationErrors::missing_rate},
      {"FalseAlarm", "share of the surface outside of the best match of each segment found (Huang and Dom 1995)",
       &SegmentationErrors::false_alarm_rate},
      {"GCE",
       "global consistency error: tolerates refinement in one direction for the whole surface (Martin et al. 2001)",
       &SegmentationErrors::global_consistency},
      {"LCE", "local consistency error: tolerates refinement in either direction at each element (Martin et al. 2001)",
       &SegmentationErrors::local_consistency},
  }};
  return entries;
}

SegmentationErrors segmentation_errors(std::span<const std::int32_t> labels, std::span<const std::int32_t> truth,
                                       std::span<const double> weights) {
  const ContingencyTable table = contingency_table(labels, truth, weights);
  const ContingencyTable other = exchanged(table);
  SegmentationErrors errors;
  double together = 0;
  for (const Overlap& overlap : table.overlaps) together += overlap.weight * overlap.weight;
  const double disagreements = sum_of_squared_segments(table) + sum_of_squared_segments(other) - 2 * together;
  const double pairs = table.total * table.total - table.squares;
  // Rounding may give slightly negative values.
  errors.rand_index = pairs > 0 ? std::clamp(disagreements / pairs, 0.0, 1.0) : 0;

  errors.missing_rate = outside_of_largest_overlaps(other);
  errors.false_alarm_rate = outside_of_largest_overlaps(table);
  errors.hamming = (errors.missing_rate + errors.false_alarm_rate) / 2;

  const std::vector<double> finds = refinement_errors(table);
  const std::vector<double> truths = in_order_of(table, other, refinement_errors(other));
  double finds_sum = 0;
  double truths_sum = 0;
  for (std::size_t i = 0; i < table.overlaps.size(); ++i) {
    const double weight = table.overlaps[i].weight / table.total;
    finds_sum += weight * finds[i];
    truths_sum += weight * truths[i];
    errors.local_consistency += weight * std::min(finds[i], truths[i]);
  }
  errors.global_consistency = std::min(finds_sum, truths_sum);
  errors.cut_discrepancy = undefined;
  return errors;
}

double cut_discrepancy(std::span<const std::int32_t> labels, std::span<const std::int32_t> truth,
                       const std::vector<MeshEdge>& edges, std::int32_t vertices, double radius) {
  check_sizes(labels, truth);
  if (!(radius > 0 && std::isfinite(radius))) {
    throw ArgumentError("the radius is " + std::to_string(radius) + "; it must be positive and finite");
  }
  check_edges(labels.size(), edges, vertices);
  const std::vector<double> found = cut_lengths(labels, edges, vertices);
  const std::vector<double> true_cuts = cut_lengths(truth, edges, vertices);
  const auto is_cut = [](double length) { return length > 0; };
  if (std::ranges::none_of(found, is_cut) && std::ranges::none_of(true_cuts, is_cut)) return 0;
  const VertexEdges ways = edges_by_vertex(edges, vertices);
  return (mean_distance(found, distances_to_cuts(ways, true_cuts)) +
          mean_distance(true_cuts, distances_to_cuts(ways, found))) /
         radius;
}

}  // namespace shapegauge
