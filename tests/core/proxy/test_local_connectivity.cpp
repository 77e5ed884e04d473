// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <utility>
#include <vector>

#include "shapegauge/core/proxy/local_connectivity.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

LocalConnectivity connectivity_of(const Shape& shape) {
  const std::vector<std::int32_t> merged = welded_vertices(shape.vertices);
  return {shape, merged, half_edges(shape.triangles, merged)};
}

/// Unit squares of two triangles each, by their lower left corners, with vertices of their own.
Shape squares(const std::vector<std::pair<double, double>>& corners) {
  Shape shape;
  shape.vertices.resize(4 * std::ssize(corners), 3);
  shape.triangles.resize(2 * std::ssize(corners), 3);
  for (int i = 0; i < std::ssize(corners); ++i) {
    const auto [x, y] = corners[static_cast<std::size_t>(i)];
    shape.vertices.middleRows(4 * i, 4) << x, y, 0, x + 1, y, 0, x + 1, y + 1, 0, x, y + 1, 0;
    shape.triangles.middleRows(2 * i, 2) << 4 * i, 4 * i + 1, 4 * i + 2, 4 * i, 4 * i + 2, 4 * i + 3;
  }
  return shape;
}

/// A U of seven squares. Its first and its last one face each other.
Shape horseshoe() { return squares({{0, 0}, {0, 1}, {0, 2}, {1, 2}, {2, 2}, {2, 1}, {2, 0}}); }

TEST(LocalConnectivity, ConnectsTheEndsOfAHorseshoeOnlyInLargeBalls) {
  LocalConnectivity connectivity = connectivity_of(horseshoe());
  const Eigen::Vector3d between(1.5, 0.5, 0);
  EXPECT_TRUE(connectivity.in_same_component(0, 13));
  for (const auto& [from, to] : {std::pair{0, 13}, {13, 0}}) {
    // The circles about the first and the last square reach the ball, the next ones from a radius of 0.71 on.
    EXPECT_FALSE(connectivity.connected_in_ball(from, to, between, 0.6));
    EXPECT_TRUE(connectivity.connected_in_ball(from, to, between, 2));
  }
  EXPECT_TRUE(connectivity.connected_in_ball(0, 1, between, 0.6)) << "the halves of a square";
}

TEST(LocalConnectivity, ConnectsSquaresWithACommonCornerThroughVerticesOnly) {
  LocalConnectivity connectivity = connectivity_of(squares({{0, 0}, {1, 1}}));
  const Eigen::Vector3d corner(1, 1, 0);
  EXPECT_FALSE(connectivity.in_same_component(0, 2));
  EXPECT_FALSE(connectivity.connected_in_ball(0, 2, corner, 3, SharedElement::edge));
  EXPECT_TRUE(connectivity.connected_in_ball(0, 2, corner, 3, SharedElement::vertex));
}

TEST(LocalConnectivity, VisitsEachTriangleOfAFanOnce) {
  // Triangles that share the origin only: n^2 pairs of neighbours.
  constexpr int count = 20'000;
  Shape fan{.vertices = Points::Zero(2 * count + 1, 3), .triangles = {}};
  fan.triangles.resize(count, 3);
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < 2; ++k) {
      const double angle = 2 * std::numbers::pi * (i + 0.5 * k) / count;
      fan.vertices.row(2 * i + k + 1) << std::cos(angle), std::sin(angle), 0;
    }
    fan.triangles.row(i) << 0, 2 * i + 1, 2 * i + 2;
  }
  LocalConnectivity connectivity = connectivity_of(fan);
  for (int to = 1; to < count; to += 1999) {
    EXPECT_FALSE(connectivity.connected_in_ball(0, to, {0, 0, 0}, 2, SharedElement::edge));
    EXPECT_TRUE(connectivity.has_visited_boundary());
    EXPECT_TRUE(connectivity.connected_in_ball(0, to, {0, 0, 0}, 2, SharedElement::vertex));
  }
  EXPECT_FALSE(connectivity.connected_in_ball(0, count / 2, {1, 0, 0}, 0.4, SharedElement::vertex));
}

TEST(LocalConnectivity, ReportsWhetherTheSearchMetAMeshBoundary) {
  LocalConnectivity closed = connectivity_of(test::box({1, 1, 1}, 1));
  EXPECT_TRUE(closed.connected_in_ball(0, 11, {0, 0, 0}, 10));
  EXPECT_FALSE(closed.has_visited_boundary());
  LocalConnectivity open = connectivity_of(horseshoe());
  EXPECT_TRUE(open.connected_in_ball(0, 13, {1.5, 1.5, 0}, 10));
  EXPECT_TRUE(open.has_visited_boundary());
}

}  // namespace

}  // namespace shapegauge
