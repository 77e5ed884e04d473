#include <gtest/gtest.h>

#include "shapegauge/metrics/measures/reciprocal_rank.h"

namespace shapegauge {
namespace {

TEST(ReciprocalRank, LooksAtTheFirstHit) {
  EXPECT_EQ(reciprocal_rank(list_of_hits({false, false, false, true, true})), 0.25);
  EXPECT_EQ(reciprocal_rank(list_of_hits({false}, false, 1)), 0);
}

TEST(ReciprocalRank, IsTheMeanOverTheOrdersOfTheTied) {
  // One hit at any of the ranks 2, 3, 4.
  EXPECT_DOUBLE_EQ(reciprocal_rank(list_of_runs({{1, 0}, {3, 1}})), (1.0 / 2 + 1.0 / 3 + 1.0 / 4) / 3);
}

}  // namespace
}  // namespace shapegauge
