// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <set>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/segmentation/paper_segmentation.h"
#include "tests/segmentation/dumbbell.h"
#include "tests/segmentation/hand_made_surface.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// Part of most nodes with a height from `low` to `high`; checks its share of them.
std::int32_t part_between(const SurfaceGraph& graph, const std::vector<std::int32_t>& parts, double low, double high,
                          double share) {
  std::map<std::int32_t, int> counts;
  int all = 0;
  for (std::int32_t i = 0; i < graph.size(); ++i) {
    const double z = graph.samples.points(i, 2);
    if (z < low || z > high) continue;
    ++counts[parts[static_cast<std::size_t>(i)]];
    ++all;
  }
  const auto most = std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; });
  EXPECT_GE(most->second, share * all) << "from " << low << " to " << high;
  return most->first;
}

/// Checks that the dumbbell's balls and bar become three parts with this field.
void expect_bar_and_balls(const SurfaceGraph& graph, const Eigen::VectorXd& field, double share) {
  const std::vector<ScalarField> fields = {{field, graph.samples.weights}};
  const std::vector<std::int32_t> parts = paper_segmentation(graph, fields, {.clusters = 2});
  const std::int32_t low = part_between(graph, parts, -4, -2.2, share);
  const std::int32_t bar = part_between(graph, parts, -0.8, 0.8, share);
  const std::int32_t high = part_between(graph, parts, 2.2, 4, share);
  EXPECT_NE(low, bar);
  EXPECT_NE(high, bar);
  EXPECT_NE(low, high);  // of one cluster, but not connected
}

TEST(ChenSegmentation, SeparatesTheBarOfADumbbellFromItsBalls) {
  const Shape shape = test::dumbbell(4);
  const SurfaceGraph graph = surface_graph(shape);
  for (const double offset : {0.01, 0.05}) {
    SCOPED_TRACE(offset);
    expect_bar_and_balls(graph, offset_sdf(shape, graph.samples, {.offset = offset}).values, 1);
  }
  SCOPED_TRACE("conventional SDF");  // less even on the balls: a patch of one may join the other cluster
  expect_bar_and_balls(graph, cone_sdf(shape, graph.samples, {}).values, 0.9);
}

TEST(ChenSegmentation, OfASphereIsOnePart) {
  const Shape shape = test::sphere(1, 3);
  const SurfaceGraph graph = surface_graph(shape);
  const std::vector<ScalarField> fields = {{Eigen::VectorXd::Constant(graph.size(), 2), graph.samples.weights}};
  const std::vector<std::int32_t> parts = paper_segmentation(graph, fields, {});
  EXPECT_EQ(std::set(parts.begin(), parts.end()).size(), 1U);
}

/// Whether six nodes in a row, each a patch, fall into two clusters of three where the border in the middle is of this
/// length and concavity, the others of length 1, and cuts are worth so much.
bool has_two_clusters(double smoothness, double length, double concavity) {
  std::vector<test::HandMadeLink> links = test::chain({1, 1, length, 1, 1});
  links[2].concavity = concavity;
  const SurfaceGraph graph = test::hand_made_graph(std::vector<double>(6, 1), links);
  const Eigen::VectorXd values{{1, 1, 1, 2, 2, 2}};
  const std::vector<ScalarField> fields = {{values, graph.samples.weights}};
  const std::vector<std::int32_t> parts =
      paper_segmentation(graph, fields, {.patches = {.count = 6}, .clusters = 2, .smoothness = smoothness});
  const std::size_t count = std::set(parts.begin(), parts.end()).size();
  EXPECT_LE(count, 2U);
  return count == 2;
}

TEST(ChenSegmentation, CostOfACutFollowsItsLengthAndDihedralAngle) {
  // In the wrong cluster three patches cost -log(1e-6) each; the cut costs -log(turn / pi) times its length over the
  // mean length of borders: 1, and at last 0.9.
  const double clusters = 3 * std::log(1e6);
  const auto expect_limit = [&](double turn, double concavity) {
    const double limit = clusters / std::log(std::numbers::pi / turn);
    EXPECT_TRUE(has_two_clusters(0.99 * limit, 1, concavity)) << concavity;
    EXPECT_FALSE(has_two_clusters(1.01 * limit, 1, concavity)) << concavity;
  };
  expect_limit(1e-3, 0);
  expect_limit(0.5, 0.5);
  expect_limit(0.05, -0.5);
  const double limit = clusters / (std::log(std::numbers::pi / 1e-3) * 0.5 / 0.9);
  EXPECT_TRUE(has_two_clusters(0.99 * limit, 0.5, 0));
  EXPECT_FALSE(has_two_clusters(1.01 * limit, 0.5, 0));
}

TEST(ChenSegmentation, RefusesOptionsOutOfRange) {
  const SurfaceGraph graph = surface_graph(test::sphere(1, 1));
  const std::vector<ScalarField> fields = {{Eigen::VectorXd::Constant(graph.size(), 2), graph.samples.weights}};
  EXPECT_THROW(paper_segmentation(graph, fields, {.smoothness = -1}), InputError);
}

/// Nodes in a row, with an edge of the given concavity before node `edge` and flat links elsewhere.
SurfaceGraph row_with_edge(std::int32_t nodes, std::int32_t edge, double concavity) {
  SurfaceGraph row;
  row.samples.points = Points::Zero(nodes, 3);
  row.samples.points.col(0).setLinSpaced(nodes, 0, nodes - 1);
  row.samples.weights = Eigen::VectorXd::Ones(nodes);
  row.first = {0};
  const auto link = [&](std::int32_t to, std::int32_t after) {
    row.links.push_back({.to = to, .length = 1, .distance = 1, .concavity = after == edge ? concavity : 0});
  };
  for (std::int32_t i = 0; i < nodes; ++i) {
    if (i > 0) link(i - 1, i);
    if (i + 1 < nodes) link(i + 1, i + 1);
    row.first.push_back(row.links.size());
  }
  return row;
}

TEST(ChenSegmentation, PrefersCutsAlongASharpEdge) {
  // The middle node belongs to neither part; the edge decides, even if convex.
  const Eigen::VectorXd values = (Eigen::VectorXd(9) << 0, 0, 0, 0, 0.5, 1, 1, 1, 1).finished();
  const std::vector<ScalarField> fields = {{values, Eigen::VectorXd::Ones(9)}};
  const PaperSegmentationOptions options{.patches = {.count = 9}, .clusters = 2, .smoothness = 4};
  for (const double concavity : {1.5, -1.5}) {
    SCOPED_TRACE(concavity);
    EXPECT_EQ(paper_segmentation(row_with_edge(9, 4, concavity), fields, options),
              (std::vector<std::int32_t>{0, 0, 0, 0, 1, 1, 1, 1, 1}));
    EXPECT_EQ(paper_segmentation(row_with_edge(9, 5, concavity), fields, options),
              (std::vector<std::int32_t>{0, 0, 0, 0, 0, 1, 1, 1, 1}));
  }
}

}  // namespace
}  // namespace shapegauge
