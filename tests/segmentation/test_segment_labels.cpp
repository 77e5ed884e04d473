#include <cstdint>
#include <gtest/gtest.h>
#include <set>
#include <stdexcept>
#include <vector>

#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/segmentation/patches.h"
#include "shapegauge/segmentation/segment_labels.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

using Labels = std::vector<std::int32_t>;

/// By the sign of the height: two caps of label 4 and a belt of label 2.
Labels caps_and_belt(const SurfaceGraph& graph) {
  Labels labels;
  for (std::int32_t i = 0; i < graph.size(); ++i) labels.push_back(std::abs(graph.samples.points(i, 2)) > 0.5 ? 4 : 2);
  return labels;
}

TEST(SegmentLabels, AreRenumberedInOrder) { EXPECT_EQ(renumbered(Labels{7, -1, 7, 3}), (Labels{0, 1, 0, 2})); }

TEST(SegmentLabels, ConnectedPartsTellCapsOfOneLabelApart) {
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

TEST(SegmentLabels, SmallPartsGoToTheLongestBorder) {
  const SurfaceGraph graph = surface_graph(test::sphere(1, 3));
  Labels labels = caps_and_belt(graph);
  labels[5] = 9;  // a triangle of its own
  EXPECT_EQ(without_small_parts(graph, labels, 0.01), renumbered(caps_and_belt(graph)));
  const Labels one = without_small_parts(graph, labels, 1.1);
  EXPECT_EQ(std::set(one.begin(), one.end()).size(), 1U);
  EXPECT_EQ(without_small_parts(graph, labels, 0), renumbered(labels));
}

TEST(SegmentLabels, NeighboursHaveDifferentColours) {
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

TEST(SegmentLabels, RefuseAnotherSurface) {
  const SurfaceGraph graph = surface_graph(test::sphere(1, 0));
  EXPECT_THROW(connected_parts(graph, Labels{1}), std::invalid_argument);
  EXPECT_THROW(without_small_parts(graph, Labels{1}, 0.1), std::invalid_argument);
  EXPECT_THROW(label_colours(graph, Labels{1}), std::invalid_argument);
}

TEST(SegmentLabels, SmallPartsThatAreLargeEnoughTogetherStay) {
  // Nodes of areas 1, 2 and 10 in a row, each a part.
  SurfaceGraph row;
  row.samples.points = Points::Zero(3, 3);
  row.samples.weights = Eigen::Vector3d(1, 2, 10);
  row.first = {0, 1, 3, 4};
  for (const std::int32_t to : {1, 0, 2, 1}) row.links.push_back({.to = to, .length = 1, .distance = 1});
  EXPECT_EQ(without_small_parts(row, Labels{0, 1, 2}, 2.5 / 13), (Labels{0, 0, 1}));
  EXPECT_EQ(without_small_parts(row, Labels{0, 1, 2}, 3.5 / 13), (Labels{0, 0, 0}));
}

}  // namespace
}  // namespace shapegauge
