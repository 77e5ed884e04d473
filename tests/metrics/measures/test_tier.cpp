#include <gtest/gtest.h>

#include "shapegauge/metrics/measures/tier.h"

namespace shapegauge {
namespace {

TEST(Tier, CountsHitsAmongTheFirstROrTwiceR) {
  const RankedList list{{true, false, false, true, false, false, true}, 3, false};
  EXPECT_DOUBLE_EQ(first_tier(list), 1.0 / 3);
  EXPECT_DOUBLE_EQ(second_tier(list), 2.0 / 3);
}

TEST(Tier, TheSecondEndsWithTheList) {
  const RankedList list{{false, true, true, true}, 3, false};
  EXPECT_DOUBLE_EQ(first_tier(list), 2.0 / 3);
  EXPECT_DOUBLE_EQ(second_tier(list), 1);
}

}  // namespace
}  // namespace shapegauge
