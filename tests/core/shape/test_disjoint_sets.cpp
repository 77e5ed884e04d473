#include <gtest/gtest.h>

#include "shapegauge/core/shape/disjoint_sets.h"

namespace shapegauge {
namespace {

TEST(DisjointSets, AreNamedByTheirLeastNumber) {
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

TEST(DisjointSets, GrowWithoutForgetting) {
  DisjointSets sets;
  sets.grow_to(2);
  sets.join(0, 1);
  sets.grow_to(4);
  EXPECT_EQ(sets.size(), 4U);
  EXPECT_EQ(sets.find(1), 0);
  EXPECT_EQ(sets.find(3), 3);
}

}  // namespace
}  // namespace shapegauge
