#include <gtest/gtest.h>

#include "shapegauge/metrics/measures/f1_at.h"

namespace shapegauge {
namespace {

TEST(F1At, IsTheHarmonicMeanOfPrecisionAndRecall) {
  const RankedList list = list_of_hits({true, false, true, false, false, true});
  EXPECT_DOUBLE_EQ(f1_at(list, 4), 2 / (1 / 0.5 + 1 / (2.0 / 3)));
  EXPECT_EQ(f1_at(list_of_hits({false, true}), 1), 0);
}

}  // namespace
}  // namespace shapegauge
