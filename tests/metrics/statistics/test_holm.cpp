#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shapegauge/metrics/statistics/holm.h"

namespace shapegauge {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;

TEST(Holm, AdjustsInAscendingOrderAndNeverDownwards) {
  // Ascending: 0.01 * 4, 0.02 * 3, 0.03 * 2 (as much as the one before), 0.5 * 1.
  EXPECT_THAT(holm_adjusted(std::vector<double>{0.5, 0.01, 0.03, 0.02}),
              ElementsAre(DoubleEq(0.5), DoubleEq(0.04), DoubleEq(0.06), DoubleEq(0.06)));
}

TEST(Holm, StaysBelowOneAndLeavesOneTestAlone) {
  EXPECT_THAT(holm_adjusted(std::vector<double>{0.4, 0.6, 0.9}), ElementsAre(1, 1, 1));
  EXPECT_THAT(holm_adjusted(std::vector<double>{0.03}), ElementsAre(0.03));
  EXPECT_TRUE(holm_adjusted(std::vector<double>{}).empty());
}

}  // namespace
}  // namespace shapegauge
