#include <gtest/gtest.h>

#include "shapegauge/metrics/measures/share_of_ideal_gain.h"

namespace shapegauge {
namespace {

double tenth_of(std::size_t rank) { return 0.1 / static_cast<double>(rank); }

TEST(ShareOfIdealGain, OneForAPerfectListExactly) {
  EXPECT_EQ(share_of_ideal_gain(list_of_hits({true, true, true, false}), tenth_of), 1);
}

TEST(ShareOfIdealGain, RelevantModelsThatAreNotInTheListCountInTheIdeal) {
  // (1/2 + 1/3) / (1 + 1/2 + 1/3)
  EXPECT_DOUBLE_EQ(share_of_ideal_gain(list_of_hits({false, true, true}, false, 1), tenth_of), 5.0 / 11);
}

}  // namespace
}  // namespace shapegauge
