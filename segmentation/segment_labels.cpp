// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/segmentation/segment_labels.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <string>
#include <unordered_map>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/shape/connectivity.h"

namespace shapegauge {

namespace {

/// Hues of different lightness (Paul Tol's "bright" and "muted" schemes), distinguishable with colour vision
/// deficiencies.
constexpr std::array<Colour, 12> palette = {{{68, 119, 170},
                                             {238, 102, 119},
                                             {34, 136, 51},
                                             {204, 187, 68},
                                             {102, 204, 238},
                                             {170, 51, 119},
                                             {187, 187, 187},
                                             {51, 34, 136},
                                             {221, 204, 119},
                                             {136, 34, 85},
                                             {68, 170, 153},
                                             {153, 153, 51}}};

void check(const SurfaceGraph& graph, std::span<const std::int32_t> labels) {
  if (std::ssize(labels) != graph.size()) {
    throw ArgumentError("there are " + std::to_string(labels.size()) + " labels for the " +
                        std::to_string(graph.size()) + " nodes of the surface");
  }
}

/// Areas of labels, which start at 0, and the lengths of their common borders.
struct LabelBorders {
  std::vector<double> areas;
  std::vector<std::map<std::int32_t, double>> lengths;
};

LabelBorders borders_of(const SurfaceGraph& graph, std::span<const std::int32_t> labels) {
  const auto count = static_cast<std::size_t>(labels.empty() ? 0 : *std::ranges::max_element(labels) + 1);
  LabelBorders borders{std::vector<double>(count, 0), std::vector<std::map<std::int32_t, double>>(count)};
  for (std::int32_t i = 0; i < graph.size(); ++i) {
    const std::int32_t label = labels[static_cast<std::size_t>(i)];
    borders.areas[static_cast<std::size_t>(label)] += graph.samples.weights[i];
    for (const SurfaceLink& link : graph.links_of(i)) {
      const std::int32_t other = labels[static_cast<std::size_t>(link.to)];
      if (other != label) borders.lengths[static_cast<std::size_t>(label)][other] += link.length;
    }
  }
  return borders;
}

}  // namespace

std::vector<std::int32_t> renumber_labels(std::span<const std::int32_t> labels) {
  std::unordered_map<std::int32_t, std::int32_t> numbers;
  std::vector<std::int32_t> result;
  result.reserve(labels.size());
  for (const std::int32_t label : labels) {
    result.push_back(numbers.emplace(label, static_cast<std::int32_t>(numbers.size())).first->second);
  }
  return result;
}

std::vector<std::int32_t> connected_parts(const SurfaceGraph& graph, std::span<const std::int32_t> labels) {
  check(graph, labels);
  DisjointSets sets;
  sets.grow_to(labels.size());
  for (std::int32_t i = 0; i < graph.size(); ++i) {
    for (const SurfaceLink& link : graph.links_of(i)) {
      if (labels[static_cast<std::size_t>(i)] == labels[static_cast<std::size_t>(link.to)]) sets.join(i, link.to);
    }
  }
  std::vector<std::int32_t> parts(labels.size());
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i] = sets.find(static_cast<std::int32_t>(i));
  return renumber_labels(parts);
}

std::vector<std::int32_t> without_slivers(const SurfaceGraph& graph, std::span<const std::int32_t> labels,
                                          double min_share) {
  check(graph, labels);
  LabelBorders borders = borders_of(graph, labels);
  const double min_area = min_share * graph.samples.weights.sum();
  std::vector<std::int32_t> merged_into(borders.areas.size());
  std::iota(merged_into.begin(), merged_into.end(), 0);
  std::vector<std::int32_t> order = merged_into;
  std::ranges::stable_sort(order, {},
                           [&](std::int32_t label) { return borders.areas[static_cast<std::size_t>(label)]; });
  for (const std::int32_t label : order) {
    auto& lengths = borders.lengths[static_cast<std::size_t>(label)];
    if (borders.areas[static_cast<std::size_t>(label)] >= min_area || lengths.empty()) continue;
    const std::int32_t other =
        std::ranges::max_element(lengths, {}, [](const auto& border) { return border.second; })->first;
    borders.areas[static_cast<std::size_t>(other)] += borders.areas[static_cast<std::size_t>(label)];
    for (const auto& [neighbour, length] : lengths) {
      auto& around = borders.lengths[static_cast<std::size_t>(neighbour)];
      around.erase(label);
      if (neighbour == other) continue;
      around[other] += length;
      borders.lengths[static_cast<std::size_t>(other)][neighbour] += length;
    }
    merged_into[static_cast<std::size_t>(label)] = other;
  }
  std::vector<std::int32_t> result(labels.begin(), labels.end());
  for (std::int32_t& label : result) {
    while (merged_into[static_cast<std::size_t>(label)] != label) label = merged_into[static_cast<std::size_t>(label)];
  }
  return result;
}

std::vector<Colour> label_colours(const SurfaceGraph& graph, std::span<const std::int32_t> labels) {
  check(graph, labels);
  const std::vector<std::int32_t> numbers = renumber_labels(labels);
  const LabelBorders borders = borders_of(graph, numbers);
  std::vector<std::int32_t> order(borders.areas.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater<>{},
                           [&](std::int32_t label) { return borders.areas[static_cast<std::size_t>(label)]; });
  constexpr std::size_t none = palette.size();
  std::vector<std::size_t> chosen(order.size(), none);
  std::size_t next = 0;
  for (const std::int32_t label : order) {
    std::array<bool, palette.size() + 1> used = {};
    for (const auto& [other, length] : borders.lengths[static_cast<std::size_t>(label)]) {
      used[chosen[static_cast<std::size_t>(other)]] = true;
    }
    // Parts that do not touch get different colours as long as there are any.
    std::size_t colour = next;
    for (std::size_t tried = 0; tried < palette.size() && used[colour]; ++tried) colour = (colour + 1) % palette.size();
    chosen[static_cast<std::size_t>(label)] = colour;
    next = (next + 1) % palette.size();
  }
  std::vector<Colour> colours;
  colours.reserve(numbers.size());
  for (const std::int32_t number : numbers) colours.push_back(palette[chosen[static_cast<std::size_t>(number)]]);
  return colours;
}

std::vector<Colour> colour_of_each_label(const SurfaceGraph& graph, std::span<const std::int32_t> labels) {
  const std::vector<Colour> of_nodes = label_colours(graph, labels);
  std::vector<Colour> colours(static_cast<std::size_t>(*std::ranges::max_element(labels)) + 1);
  for (std::size_t i = 0; i < labels.size(); ++i) colours[static_cast<std::size_t>(labels[i])] = of_nodes[i];
  return colours;
}

}  // namespace shapegauge
