#include <gtest/gtest.h>

#include "shapegauge/metrics/measures/discounted_cumulative_gain.h"

namespace shapegauge {
namespace {

TEST(DiscountedCumulativeGain, OfAWorkedExample) {
  // Hits at ranks 2, 4, 8 gain 1, 1/2, 1/3; in front they would gain 1, 1, 1/log2(3).
  const RankedList list = list_of_hits({false, true, false, true, false, false, false, true});
  const double log2_of_3 = 1.584962500721156;
  EXPECT_DOUBLE_EQ(discounted_cumulative_gain(list), (1 + 0.5 + 1.0 / 3) / (2 + 1 / log2_of_3));
}

TEST(DiscountedCumulativeGain, IsExactlyOneForAPerfectList) {
  for (std::size_t relevant = 1; relevant <= 40; ++relevant) {
    const RankedList list = list_of_runs({{relevant, relevant}, {60 - relevant, 0}});
    EXPECT_EQ(discounted_cumulative_gain(list), 1) << relevant;
  }
}

TEST(DiscountedCumulativeGain, CountsTheFirstTwoRanksTheSame) {
  EXPECT_EQ(discounted_cumulative_gain(list_of_hits({true, false, false})), 1);
  EXPECT_EQ(discounted_cumulative_gain(list_of_hits({false, true, false})), 1);
  EXPECT_LT(discounted_cumulative_gain(list_of_hits({false, false, true})), 1);
}

}  // namespace
}  // namespace shapegauge
