// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <gtest/gtest.h>
#include <set>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/segmentation/patches.h"
#include "shapegauge/segmentation/segment_labels.h"
#include "tests/segmentation/hand_made_surface.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

using Labels = std::vector<std::int32_t>;

/// By height: two caps of label 4 and a belt of label 2.
Labels caps_and_belt(const SurfaceGraph& graph) {
  Labels labels;
  for (std::int32_t i = 0; i < graph.size(); ++i) labels.push_back(std::abs(graph.samples.points(i, 2)) > 0.5 ? 4 : 2);
  return labels;
}

TEST(SegmentLabels, AreRenumberedByFirstOccurrence) {
  EXPECT_EQ(renumber_labels(Labels{7, -1, 7, 3}), (Labels{0, 1, 0, 2}));
}

TEST(SegmentLabels, AreSplitIntoConnectedParts) {
  const SurfaceGraph graph = surface_graph(test::sphere(1, 3));
  const Labels parts = connected_parts(graph, caps_and_belt(graph));
  EXPECT_EQ(std::set(parts.begin(), parts.end()).size(), 3U);
  for (std::int32_t i = 0; i < graph.size(); ++i) {
    for (std::int32_t j = 0; j < i; ++j) {
      const double a = graph.samples.points(i, 2);
      const double b = graph.samples.points(j, 2);
      const auto zone = [](double z) { return z > 0.5 ? 1 : z < -0.5 ? -1 : 0; };
      ASSERT_EQ(parts[static_cast<std::size_t>(i)] == parts[static_cast<std::size_t>(j)], zone(a) == zone(b));
    }
  }
}

TEST(SegmentLabels, GiveSliversTheLabelOfTheNeighbourWithTheLongestBorder) {
  const Shape sphere = test::sphere(1, 3);
  const SurfaceGraph graph = surface_graph(sphere);
  const Labels halves = [&] {
    Labels labels;
    for (std::int32_t i = 0; i < graph.size(); ++i) labels.push_back(graph.samples.points(i, 2) > 0 ? 1 : 0);
    return labels;
  }();
  Labels labels = halves;
  labels[5] = 2;
  labels[200] = 3;
  EXPECT_EQ(without_slivers(graph, labels, 0.01), halves);
  EXPECT_EQ(without_slivers(graph, labels, 1e-5), labels) << "larger than the least share";
  // A chain of slivers joins the half around it.
  for (const SurfaceLink& link : graph.links_of(5)) {
    if (halves[static_cast<std::size_t>(link.to)] == halves[5]) labels[static_cast<std::size_t>(link.to)] = 4;
  }
  EXPECT_EQ(without_slivers(graph, labels, 0.01), halves);
}

TEST(SegmentLabels, MergeTheSmallestSliverIntoItsNeighbourFirst) {
  const SurfaceGraph graph = test::hand_made_graph({100, 2, 1, 97}, test::chain({1, 3, 2}));
  const Labels labels = {0, 1, 2, 3};
  EXPECT_EQ(without_slivers(graph, labels, 0.0125), (Labels{0, 1, 1, 3})) << "2 + 1 is above 2.5";
  EXPECT_EQ(without_slivers(graph, labels, 0.02), (Labels{0, 3, 3, 3})) << "a border of 2 with 3, and of 1 with 0";
}

TEST(SegmentLabels, GetColoursByDescendingArea) {
  const std::vector<Colour> colours =
      label_colours(test::hand_made_graph({1, 5, 3}, test::chain({1, 1})), Labels{0, 1, 2});
  EXPECT_EQ(colours[1], (Colour{68, 119, 170}));
  EXPECT_EQ(colours[2], (Colour{238, 102, 119}));
  EXPECT_EQ(colours[0], (Colour{34, 136, 51}));
}

TEST(SegmentLabels, ReuseColoursOnlyForPartsThatDoNotTouch) {
  // Fourteen parts by falling area. Two reuse a colour: 12 touches 0, whose colour is next; 13 does not
  // touch 1.
  std::vector<double> areas;
  Labels labels;
  for (int i = 0; i < 14; ++i) {
    areas.push_back(20 - i);
    labels.push_back(i);
  }
  const std::vector<Colour> colours = label_colours(test::hand_made_graph(areas, {{0, 12, 1}}), labels);
  EXPECT_EQ(colours[12], colours[1]);
  EXPECT_EQ(colours[13], colours[1]);
}

TEST(SegmentLabels, GiveAdjacentPartsDifferentColours) {
  const SurfaceGraph graph = surface_graph(test::sphere(1, 4));
  const Labels patch = patches(graph, {.count = 60});
  const std::vector<Colour> colours = label_colours(graph, patch);
  for (std::int32_t i = 0; i < graph.size(); ++i) {
    for (const SurfaceLink& link : graph.links_of(i)) {
      const auto a = static_cast<std::size_t>(i);
      const auto b = static_cast<std::size_t>(link.to);
      EXPECT_EQ(patch[a] == patch[b], colours[a] == colours[b]);
    }
  }
}

TEST(SegmentLabels, AreRejectedUnlessTheirNumberMatchesTheSurface) {
  const SurfaceGraph graph = surface_graph(test::sphere(1, 0));
  EXPECT_THROW(connected_parts(graph, Labels{1}), ArgumentError);
  EXPECT_THROW(label_colours(graph, Labels{1}), ArgumentError);
}

}  // namespace
}  // namespace shapegauge
