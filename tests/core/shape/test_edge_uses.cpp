#include <gtest/gtest.h>

#include "shapegauge/core/shape/edge_uses.h"

namespace shapegauge {
namespace {

TEST(EdgeUses, OfTwoTrianglesWithACommonEdge) {
  const Triangles triangles{{0, 1, 2}, {2, 1, 3}, {1, 1, 2}};
  const std::vector<std::int32_t> merged{0, 1, 2, 3};
  const std::vector<EdgeUse> uses = edge_uses(triangles, merged);
  ASSERT_EQ(uses.size(), 6U) << "the last triangle has corners at two places";
  std::vector<std::size_t> sizes;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
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

TEST(EdgeUses, NamesVerticesByTheirPlace) {
  const std::vector<EdgeUse> uses =
      edge_uses(Triangles{{0, 1, 2}, {5, 4, 3}}, std::vector<std::int32_t>{0, 1, 2, 0, 1, 2});
  std::size_t edges = 0;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    ++edges;
    EXPECT_EQ(edge.size(), 2U);
  });
  EXPECT_EQ(edges, 3U);
}

}  // namespace
}  // namespace shapegauge
