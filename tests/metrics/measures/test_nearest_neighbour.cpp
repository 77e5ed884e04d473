#include <gtest/gtest.h>

#include "shapegauge/metrics/measures/nearest_neighbour.h"

namespace shapegauge {
namespace {

TEST(NearestNeighbour, LooksAtTheFirstRank) {
  EXPECT_EQ(nearest_neighbour(list_of_hits({true, false})), 1);
  EXPECT_EQ(nearest_neighbour(list_of_hits({false, true})), 0);
}

TEST(NearestNeighbour, PassesOverTheQuery) {
  EXPECT_EQ(nearest_neighbour(list_of_hits({true, false, true}, true)), 0);
  EXPECT_EQ(nearest_neighbour(list_of_hits({true, true, false}, true)), 1);
}

}  // namespace
}  // namespace shapegauge
