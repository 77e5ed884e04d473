#include <gtest/gtest.h>

#include "shapegauge/metrics/measures/nearest_neighbour.h"

namespace shapegauge {
namespace {

TEST(NearestNeighbour, LooksAtTheFirstRank) {
  EXPECT_EQ(nearest_neighbour({{true, false}, 1, false}), 1);
  EXPECT_EQ(nearest_neighbour({{false, true}, 1, false}), 0);
}

TEST(NearestNeighbour, PassesOverTheQuery) {
  EXPECT_EQ(nearest_neighbour({{true, false, true}, 2, true}), 0);
  EXPECT_EQ(nearest_neighbour({{true, true, false}, 2, true}), 1);
}

}  // namespace
}  // namespace shapegauge
