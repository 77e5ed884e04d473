#include <gtest/gtest.h>

#include "shapegauge/metrics/measures/normalised_discounted_gain.h"

namespace shapegauge {
namespace {

TEST(NormalisedDiscountedGain, OfAWorkedExample) {
  // Hits at ranks 1, 3, 7 gain 1, 1/2, 1/3; in front they would gain 1, 1/log2(3), 1/2.
  const RankedList list = list_of_hits({true, false, true, false, false, false, true});
  const double log2_of_3 = 1.584962500721156;
  EXPECT_DOUBLE_EQ(normalised_discounted_gain(list), (1 + 0.5 + 1.0 / 3) / (1.5 + 1 / log2_of_3));
}

TEST(NormalisedDiscountedGain, IsExactlyOneForAPerfectList) {
  EXPECT_EQ(normalised_discounted_gain(list_of_runs({{19, 19}, {580, 0}})), 1);
}

}  // namespace
}  // namespace shapegauge
