#include <gtest/gtest.h>

#include "shapegauge/metrics/measures/discounted_cumulative_gain.h"

namespace shapegauge {
namespace {

TEST(DiscountedCumulativeGain, OfAWorkedExample) {
  // Hits at ranks 2, 4, 8 gain 1, 1/2, 1/3; in front they would gain 1, 1, 1/log2(3).
  const RankedList list{{false, true, false, true, false, false, false, true}, 3, false};
  const double log2_of_3 = 1.584962500721156;
  EXPECT_DOUBLE_EQ(discounted_cumulative_gain(list), (1 + 0.5 + 1.0 / 3) / (2 + 1 / log2_of_3));
}

TEST(DiscountedCumulativeGain, IsExactlyOneForAPerfectList) {
  for (std::size_t relevant = 1; relevant <= 40; ++relevant) {
    RankedList list{std::vector<bool>(60, false), relevant, false};
    for (std::size_t i = 0; i < relevant; ++i) list.hits[i] = true;
    EXPECT_EQ(discounted_cumulative_gain(list), 1) << relevant;
  }
}

TEST(DiscountedCumulativeGain, CountsTheFirstTwoRanksTheSame) {
  EXPECT_EQ(discounted_cumulative_gain({{true, false, false}, 1, false}), 1);
  EXPECT_EQ(discounted_cumulative_gain({{false, true, false}, 1, false}), 1);
  EXPECT_LT(discounted_cumulative_gain({{false, false, true}, 1, false}), 1);
}

}  // namespace
}  // namespace shapegauge
