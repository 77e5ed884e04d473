// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <utility>
#include <vector>

#include "shapegauge/core/shape/connectivity.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

RC_GTEST_PROP(CountingSort, IsAStableSort, ()) {
  constexpr int keys = 12;
  const auto drawn = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, keys));
  std::vector<std::pair<int, std::size_t>> values;
  for (std::size_t i = 0; i < drawn.size(); ++i) values.emplace_back(drawn[i], i);
  const auto counted = bucket_sort(values, keys, [](const auto& value) { return value.first; });
  std::ranges::sort(values);  // by key, then by index
  RC_ASSERT(counted.values == values);
  RC_ASSERT(counted.first.size() == keys + 1U);
  RC_ASSERT(counted.first.back() == values.size());
  for (std::size_t key = 0; key < keys; ++key) {
    for (std::size_t i = counted.first[key]; i < counted.first[key + 1]; ++i) {
      RC_ASSERT(counted.values[i].first == static_cast<int>(key));
    }
  }
}

TEST(DisjointSets, AreIdentifiedByTheirSmallestIndex) {
  DisjointSets sets;
  sets.grow_to(6);
  for (std::int32_t i = 0; i < 6; ++i) EXPECT_EQ(sets.find(i), i);
  sets.join(5, 3);
  sets.join(3, 4);
  sets.join(2, 2);
  EXPECT_EQ(sets.find(5), 3);
  EXPECT_EQ(sets.find(4), 3);
  EXPECT_EQ(sets.find(2), 2);
  sets.join(0, 4);
  EXPECT_EQ(sets.find(5), 0);
  EXPECT_EQ(sets.find(1), 1);
}

TEST(DisjointSets, KeepEarlierUnionsWhenGrowing) {
  DisjointSets sets;
  sets.grow_to(2);
  sets.join(0, 1);
  sets.grow_to(4);
  EXPECT_EQ(sets.size(), 4U);
  EXPECT_EQ(sets.find(1), 0);
  EXPECT_EQ(sets.find(3), 3);
}

TEST(WeldedVertices, MapToTheFirstVertexAtTheSamePosition) {
  const Points points{{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {-0.0, 0, 0}, {1, 2, 4}, {1, 2, 3}};
  EXPECT_EQ(welded_vertices(points), (std::vector<std::int32_t>{0, 1, 0, 1, 4, 0}));
  EXPECT_TRUE(welded_vertices(Points(0, 3)).empty());
}

TEST(HalfEdges, OfTwoAdjacentTrianglesShareTheCommonEdge) {
  const Triangles triangles{{0, 1, 2}, {2, 1, 3}, {1, 1, 2}};
  const std::vector<std::int32_t> merged{0, 1, 2, 3};
  const std::vector<HalfEdge> uses = half_edges(triangles, merged);
  ASSERT_EQ(uses.size(), 6U) << "the last triangle has corners at two positions";
  std::vector<std::size_t> sizes;
  for_each_edge(uses, [&](std::span<const HalfEdge> edge) {
    sizes.push_back(edge.size());
    if (edge.size() < 2) return;
    EXPECT_EQ(edge[0].low, 1);
    EXPECT_EQ(edge[0].high, 2);
    EXPECT_EQ(edge[0].triangle, 0);
    EXPECT_EQ(edge[0].corner, 1);
    EXPECT_TRUE(edge[0].forward);
    EXPECT_EQ(edge[1].triangle, 1);
    EXPECT_EQ(edge[1].corner, 0);
    EXPECT_FALSE(edge[1].forward);
  });
  EXPECT_EQ(sizes, (std::vector<std::size_t>{1, 1, 2, 1, 1}));
}

TEST(HalfEdges, ConnectWeldedVertices) {
  const std::vector<HalfEdge> uses =
      half_edges(Triangles{{0, 1, 2}, {5, 4, 3}}, std::vector<std::int32_t>{0, 1, 2, 3, 1, 2});
  std::vector<std::size_t> sizes;
  for_each_edge(uses, [&](std::span<const HalfEdge> edge) { sizes.push_back(edge.size()); });
  EXPECT_EQ(sizes, (std::vector<std::size_t>{1, 1, 2, 1, 1}));
}

TEST(HalfEdges, OfDoubledTrianglesAreCountedOnce) {
  const std::vector<HalfEdge> uses =
      half_edges(Triangles{{0, 1, 2}, {5, 4, 3}, {0, 1, 2}}, std::vector<std::int32_t>{0, 1, 2, 0, 1, 2});
  ASSERT_EQ(uses.size(), 3U);
  for (const HalfEdge& use : uses) EXPECT_EQ(use.triangle, 0);
}

TEST(Closedness, HoldsForClosedSurfacesOfAnyOrientation) {
  const Shape sphere = test::sphere(1, 2);
  EXPECT_TRUE(is_closed(sphere));
  EXPECT_TRUE(is_closed(test::flipped(sphere)));
  EXPECT_TRUE(is_closed(test::joined({sphere, test::torus(3, 1, 12, 8)})));
}

TEST(Closedness, HoldsIfTwoBodiesShareAnEdge) {
  Shape pair{.vertices = Points{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}}, .triangles = {}};
  pair.triangles = Triangles{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}, {0, 1, 4}, {0, 1, 5}, {0, 4, 5}, {1, 4, 5}};
  EXPECT_TRUE(is_closed(pair)) << "four triangles meet at the edge from 0 to 1";
  pair.triangles.conservativeResize(7, Eigen::NoChange);
  EXPECT_FALSE(is_closed(pair));
}

TEST(Closedness, FailsIfOneTriangleIsMissing) {
  Shape sphere = test::sphere(1, 2);
  sphere.triangles.conservativeResize(sphere.triangles.rows() - 1, Eigen::NoChange);
  EXPECT_FALSE(is_closed(sphere));
  EXPECT_FALSE(is_closed(Shape{}));
}

TEST(Closedness, IgnoresDegenerateTriangles) {
  for (const Eigen::Matrix3d& rotation : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), test::rotation(1)}) {
    Shape box = test::box({1, 1, 1}, 2);
    std::vector<std::int32_t> edge;
    for (std::int32_t v = 0; v < box.vertices.rows(); ++v) {
      const auto same = [&](std::int32_t other) { return box.vertices.row(other) == box.vertices.row(v); };
      if (box.vertices(v, 0) == -0.5 && box.vertices(v, 1) == -0.5 && std::ranges::none_of(edge, same)) {
        edge.push_back(v);
      }
    }
    ASSERT_EQ(edge.size(), 3U);
    box = test::transformed(box, 1, rotation, {0, 0, 0});
    box.triangles.conservativeResize(box.triangles.rows() + 1, Eigen::NoChange);
    box.triangles.bottomRows<1>() << edge[0], edge[1], edge[2];
    EXPECT_TRUE(is_closed(box));
    EXPECT_TRUE(is_closed_and_oriented(box));
    box.triangles = box.triangles.bottomRows(box.triangles.rows() - 1).eval();
    EXPECT_FALSE(is_closed(box)) << "a triangle with area is missing";
  }
}

TEST(Closedness, HoldsForAClosedTriangleSoup) { EXPECT_TRUE(is_closed(test::soup(test::sphere(1, 1)))); }

TEST(Closedness, IgnoresTrianglesWithARepeatedCorner) {
  Shape sphere = test::sphere(1, 1);
  sphere.triangles.conservativeResize(sphere.triangles.rows() + 1, Eigen::NoChange);
  sphere.triangles.bottomRows(1) << 0, 0, 1;
  EXPECT_TRUE(is_closed(sphere));
}

}  // namespace

}  // namespace shapegauge
