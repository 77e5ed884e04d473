// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/segmentation/surface_graph.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

/// Two squares of two triangles each that meet at the y axis; the right one rises with slope `slope`.
Shape valley(double slope) {
  return {.vertices = Points{{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {-1, 1, 0}, {1, 0, slope}, {1, 1, slope}},
          .triangles = Triangles{{0, 1, 2}, {2, 1, 3}, {0, 4, 1}, {4, 5, 1}}};
}

double concavity(const SurfaceGraph& graph, std::int32_t from, std::int32_t to) {
  for (const SurfaceLink& link : graph.links_of(from)) {
    if (link.to == to) return link.concavity;
  }
  ADD_FAILURE() << from << " and " << to << " are no neighbours";
  return 0;
}

TEST(SurfaceGraph, ConcavityIsPositiveInAValleyAndNegativeOnARidge) {
  const double angle = std::atan(0.5);
  EXPECT_NEAR(concavity(surface_graph(valley(0.5)), 0, 2), angle, 1e-12);
  EXPECT_NEAR(concavity(surface_graph(valley(-0.5)), 0, 2), -angle, 1e-12);
  EXPECT_NEAR(concavity(surface_graph(valley(0.5)), 0, 1), 0, 1e-12);
}

TEST(SurfaceGraph, ConcavityDoesNotChangeIfATriangleIsReversed) {
  Shape shape = valley(0.5);
  std::swap(shape.triangles(2, 0), shape.triangles(2, 1));
  EXPECT_NEAR(concavity(surface_graph(shape), 0, 2), std::atan(0.5), 1e-12);
}

TEST(SurfaceGraph, LinksHaveTheLengthOfTheSharedEdgeAndCentroidDistance) {
  const SurfaceGraph graph = surface_graph(valley(0));
  for (const SurfaceLink& link : graph.links_of(0)) {
    EXPECT_DOUBLE_EQ(link.length, link.to == 2 ? 1 : std::numbers::sqrt2);
    if (link.to != 1) continue;
    EXPECT_DOUBLE_EQ(link.distance, 2 * std::hypot(1 / 6.0, 1 / 6.0));
  }
}

TEST(SurfaceGraph, EveryLinkHasItsReverse) {
  for (const Shape& shape : {test::sphere(1, 2), test::soup(test::box({1, 2, 3}, 2)),
                             Shape{.vertices = test::torus(2, 1, 12, 20).vertices, .triangles = {}}}) {
    const SurfaceGraph graph = surface_graph(shape);
    std::set<std::pair<std::int32_t, std::int32_t>> links;
    for (std::int32_t i = 0; i < graph.size(); ++i) {
      for (const SurfaceLink& link : graph.links_of(i)) EXPECT_TRUE(links.emplace(i, link.to).second);
    }
    EXPECT_FALSE(links.empty());
    for (const auto& [from, to] : links) EXPECT_TRUE(links.contains({to, from}));
  }
}

TEST(SurfaceGraph, LinksEachTriangleOfAClosedMeshToThreeOthers) {
  const SurfaceGraph graph = surface_graph(test::soup(test::sphere(1, 2)));
  for (std::int32_t i = 0; i < graph.size(); ++i) {
    EXPECT_EQ(graph.links_of(i).size(), 3U);
    for (const SurfaceLink& link : graph.links_of(i)) EXPECT_LT(link.concavity, 0);
  }
}

/// Numbers of links of the first triangles that have no open edges.
std::vector<std::size_t> link_counts(const SurfaceGraph& graph, std::int32_t count) {
  std::vector<std::size_t> counts;
  for (std::int32_t i = 0; i < count; ++i) counts.push_back(graph.links_of(i).size());
  return counts;
}

TEST(SurfaceGraph, LinksTrianglesAtANonManifoldEdgeInAChain) {
  // Three tetrahedra with a common edge, shared by six triangles.
  Shape three;
  three.vertices.resize(8, 3);
  three.vertices.topRows(2) << 0, 0, 0, 0, 0, 1;
  three.triangles.resize(12, 3);
  for (int k = 0; k < 3; ++k) {
    const int p = 2 + 2 * k;
    const int q = p + 1;
    three.vertices.row(p) << std::cos(2 * k), std::sin(2 * k), 0.5;
    three.vertices.row(q) << std::cos(2 * k + 0.7), std::sin(2 * k + 0.7), 0.5;
    three.triangles.middleRows(4 * k, 4) << 0, 1, p, 0, 1, q, 0, p, q, 1, p, q;
  }
  const SurfaceGraph graph = surface_graph(three);
  std::vector<std::size_t> counts = link_counts(graph, graph.size());
  std::ranges::sort(counts);
  // Six triangles do not have the edge. Of those that do, the two at the ends of the row have one neighbour there.
  EXPECT_THAT(counts, testing::ElementsAre(3, 3, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4));
}

TEST(SurfaceGraph, LinksTheThreeNeighboursOfAMissingTriangle) {
  const Shape whole = test::sphere(1, 2);
  Shape holed = whole;
  holed.triangles = whole.triangles.bottomRows(whole.triangles.rows() - 1);
  const SurfaceGraph graph = surface_graph(holed);
  const SurfaceGraph of_whole = surface_graph(whole);
  std::vector<std::int32_t> around;
  for (const SurfaceLink& link : of_whole.links_of(0)) around.push_back(link.to - 1);
  for (std::int32_t i = 0; i < graph.size(); ++i) {
    const bool at_gap = std::ranges::count(around, i) > 0;
    ASSERT_EQ(graph.links_of(i).size(), at_gap ? 4U : 3U);  // two neighbours, and the two others at the gap
    if (!at_gap) continue;
    for (const SurfaceLink& link : graph.links_of(i)) {
      EXPECT_LT(link.concavity, 0);  // convex across the gap, too
      const double straight = (graph.samples.points.row(link.to) - graph.samples.points.row(i)).norm();
      EXPECT_GE(link.distance, straight);
      EXPECT_LE(link.distance, 2 * straight);
    }
  }
}

TEST(SurfaceGraph, LinksAnIsolatedTriangleBetweenGapsToItsNeighbours) {
  // A strip without every second triangle: the others meet only at vertices.
  const Shape strip{.vertices = Points{{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {3, 1, 0}, {4, 0, 0}},
                    .triangles = Triangles{{0, 2, 1}, {2, 4, 3}}};
  const SurfaceGraph graph = surface_graph(strip);
  ASSERT_THAT(link_counts(graph, 2), testing::ElementsAre(1, 1));
  // At (2, 0, 0), from centroid to centroid, and as wide as half of the longer edges there.
  EXPECT_DOUBLE_EQ(graph.links[0].distance, 2 * std::hypot(1, 1 / 3.0));
  EXPECT_DOUBLE_EQ(graph.links[0].length, 1);
  EXPECT_EQ(graph.links[0].concavity, 0);
}

TEST(SurfaceGraph, LinksOfACloudHaveTheDistanceAndWidthOfTheirPoints) {
  const Shape cloud{.vertices = test::sphere(2, 3).vertices, .triangles = {}};
  const SurfaceGraph graph = surface_graph(cloud);
  const Samples& samples = graph.samples;
  for (std::int32_t i = 0; i < graph.size(); ++i) {
    EXPECT_GE(graph.links_of(i).size(), 8U);
    for (const SurfaceLink& link : graph.links_of(i)) {
      EXPECT_NEAR(link.distance, (samples.points.row(i) - samples.points.row(link.to)).norm(), 1e-12);
      EXPECT_DOUBLE_EQ(link.length, (std::sqrt(samples.weights[i]) + std::sqrt(samples.weights[link.to])) / 2);
      EXPECT_NEAR(std::abs(link.concavity), link.distance / 2, 0.06) << "the angle seen from the middle";
    }
  }
}

TEST(SurfaceGraph, RefusesAnEmptyShape) { EXPECT_THROW(surface_graph(Shape{}), InputError); }

}  // namespace
}  // namespace shapegauge
