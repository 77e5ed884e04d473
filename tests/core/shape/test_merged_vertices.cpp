#include <gtest/gtest.h>

#include "shapegauge/core/shape/merged_vertices.h"

namespace shapegauge {
namespace {

TEST(MergedByPlace, NamesTheFirstVertexAtEachPlace) {
  const Points points{{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {-0.0, 0, 0}, {1, 2, 4}, {1, 2, 3}};
  EXPECT_EQ(merged_by_place(points), (std::vector<std::int32_t>{0, 1, 0, 1, 4, 0}));
  EXPECT_TRUE(merged_by_place(Points(0, 3)).empty());
}

}  // namespace
}  // namespace shapegauge
