// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "shapegauge/core/shape/connectivity.h"
#include "shapegauge/core/shape/link_components.h"

namespace shapegauge {
namespace {

Points on_a_line(const std::vector<double>& coordinates) {
  Points points = Points::Zero(static_cast<Eigen::Index>(coordinates.size()), 3);
  for (std::size_t i = 0; i < coordinates.size(); ++i) points(static_cast<Eigen::Index>(i), 0) = coordinates[i];
  return points;
}

TEST(NearestSegments, JoinEachPointToItsNearestNeighbour) {
  for (const Segment& segment : nearest_segments(on_a_line({0, 1, 3}), 1)) {
    const bool left = std::min(segment.a, segment.b) == 0;
    EXPECT_EQ(std::max(segment.a, segment.b), left ? 1 : 2);
    EXPECT_EQ(segment.length, left ? 1 : 2);
  }
}

TEST(LinkComponents, LinksAllComponentsByShortestSegments) {
  const Points points = on_a_line({0, 1, 10, 11, 100});
  std::vector<Segment> segments{{0, 1, 1}, {2, 3, 1}};
  EXPECT_EQ(link_components(points, 1, segments), 3);
  DisjointSets sets;
  sets.grow_to(5);
  for (const Segment& segment : segments) {
    sets.join(segment.a, segment.b);
    EXPECT_EQ(segment.length, (points.row(segment.a) - points.row(segment.b)).norm());
  }
  for (std::int32_t i = 0; i < 5; ++i) EXPECT_EQ(sets.find(i), 0);
  const auto has = [&](std::int32_t a, std::int32_t b) {
    return std::ranges::any_of(segments, [&](const Segment& segment) {
      return std::min(segment.a, segment.b) == a && std::max(segment.a, segment.b) == b;
    });
  };
  EXPECT_TRUE(has(1, 2));
  EXPECT_TRUE(has(3, 4));
  EXPECT_FALSE(has(0, 4));
}

TEST(LinkComponents, AddsNoLinksToASingleComponent) {
  std::vector<Segment> segments{{0, 1, 1}, {1, 2, 2}};
  EXPECT_EQ(link_components(on_a_line({0, 1, 3}), 1, segments), 1);
  EXPECT_EQ(segments.size(), 2U);
}

}  // namespace
}  // namespace shapegauge
