// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gtest/gtest.h>
#include <set>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/segmentation/patches.h"
#include "shapegauge/segmentation/segment_labels.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

std::int32_t number_of_patches(const std::vector<std::int32_t>& labels) {
  return static_cast<std::int32_t>(std::set(labels.begin(), labels.end()).size());
}

TEST(SurfacePatches, AreConnectedEquallyLargeAndOfTheRequestedNumber) {
  const SurfaceGraph graph = surface_graph(test::sphere(1, 4));
  const std::vector<std::int32_t> patch = patches(graph, {.count = 40});
  EXPECT_EQ(number_of_patches(patch), 40);
  EXPECT_EQ(*std::ranges::max_element(patch), 39);
  EXPECT_EQ(number_of_patches(connected_parts(graph, patch)), 40);
  for (std::int32_t p = 0; p < 40; ++p) {
    const auto size = static_cast<double>(std::ranges::count(patch, p)) / static_cast<double>(patch.size());
    EXPECT_GT(size, 0.4 / 40);
    EXPECT_LT(size, 2.0 / 40);
  }
}

TEST(SurfacePatches, HaveBordersAtLinksOfHighCost) {
  // The ends of a long box are far apart, but its edges are expensive to cross.
  const SurfaceGraph graph = surface_graph(test::box({1, 1, 1}, 8));
  std::vector<double> costs;
  for (const SurfaceLink& link : graph.links) costs.push_back(link.concavity < -1 ? 100 : link.distance);
  const std::vector<std::int32_t> patch = patches(graph, {.count = 6}, costs);
  for (std::int32_t i = 0; i < graph.size(); ++i) {
    for (const SurfaceLink& link : graph.links_of(i)) {
      EXPECT_EQ(patch[static_cast<std::size_t>(i)] == patch[static_cast<std::size_t>(link.to)], link.concavity > -1);
    }
  }
}

TEST(SurfacePatches, DependOnRelativeNodeAreasButNotOnTheirUnit) {
  SurfaceGraph graph = surface_graph(test::sphere(1, 3));
  const std::vector<std::int32_t> moved = patches(graph, {.count = 20});
  graph.samples.weights *= 1024;
  EXPECT_EQ(moved, patches(graph, {.count = 20})) << "whatever the unit of area";
  graph.samples.weights.head(graph.size() / 2) *= 100;
  EXPECT_NE(moved, patches(graph, {.count = 20}));
}

TEST(SurfacePatches, CoverEveryConnectedComponent) {
  const Shape balls = test::joined(
      {test::sphere(1, 1), test::transformed(test::sphere(1, 1), 1, Eigen::Matrix3d::Identity(), {5, 0, 0})});
  const std::vector<std::int32_t> patch = patches(surface_graph(balls), {.count = 1});
  EXPECT_EQ(number_of_patches(patch), 2);
  EXPECT_NE(patch.front(), patch.back());
}

TEST(SurfacePatches, AreAtMostAsManyAsTriangles) {
  const SurfaceGraph graph = surface_graph(test::box({1, 1, 1}, 1));
  EXPECT_EQ(number_of_patches(patches(graph, {.count = 1000})), 12);
}

TEST(SurfacePatches, AreReproducibleForOneSeedAndDifferForAnother) {
  const SurfaceGraph graph = surface_graph(test::torus(2, 0.5, 16, 40));
  EXPECT_EQ(patches(graph, {.count = 20, .seed = 7}), patches(graph, {.count = 20, .seed = 7}));
  EXPECT_NE(patches(graph, {.count = 20, .seed = 7}), patches(graph, {.count = 20, .seed = 8}));
}

TEST(SurfacePatches, RefuseOptionsOutOfRange) {
  const SurfaceGraph graph = surface_graph(test::sphere(1, 0));
  EXPECT_THROW(patches(graph, {.count = 0}), InputError);
  EXPECT_THROW(patches(graph, {}, std::vector<double>{1}), ArgumentError);
}

TEST(SurfacePatches, AssignANodeAtEqualDistanceToTheFirstCentre) {
  // Three nodes in a row; the first centre is the first node, the second the last.
  SurfaceGraph row;
  row.samples.points = Points::Zero(3, 3);
  row.samples.points.col(0) << 0, 1, 2;
  row.samples.weights = Eigen::VectorXd::Ones(3);
  row.first = {0, 1, 3, 4};
  for (const std::int32_t to : {1, 0, 2, 1}) row.links.push_back({.to = to, .length = 1, .distance = 1});
  std::uint64_t seed = 0;
  while (RandomNumbers(seed).below(3) != 0) ++seed;
  EXPECT_EQ(patches(row, {.count = 2, .seed = seed}), (std::vector<std::int32_t>{0, 0, 1}));
}

}  // namespace
}  // namespace shapegauge
