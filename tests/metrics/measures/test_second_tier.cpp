#include <gtest/gtest.h>

#include "shapegauge/metrics/measures/second_tier.h"

namespace shapegauge {
namespace {

TEST(SecondTier, CountsHitsAmongTheFirstTwiceR) {
  EXPECT_DOUBLE_EQ(second_tier(list_of_hits({true, false, false, true, false, false, true})), 2.0 / 3);
}

TEST(SecondTier, EndsWithTheList) { EXPECT_DOUBLE_EQ(second_tier(list_of_hits({false, true, true, true})), 1); }

}  // namespace
}  // namespace shapegauge
