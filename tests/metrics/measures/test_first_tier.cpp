#include <gtest/gtest.h>

#include "shapegauge/metrics/measures/first_tier.h"

namespace shapegauge {
namespace {

TEST(FirstTier, CountsHitsAmongTheFirstR) {
  EXPECT_DOUBLE_EQ(first_tier(list_of_hits({true, false, false, true, false, false, true})), 1.0 / 3);
}

TEST(FirstTier, CountsRelevantModelsThatAreNotInTheList) {
  EXPECT_DOUBLE_EQ(first_tier(list_of_hits({true, false}, false, 3)), 1.0 / 4);
}

}  // namespace
}  // namespace shapegauge
