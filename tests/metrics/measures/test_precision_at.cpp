#include <gtest/gtest.h>

#include "shapegauge/metrics/measures/precision_at.h"

namespace shapegauge {
namespace {

TEST(PrecisionAt, DividesByKEvenWhereTheListIsShorter) {
  const RankedList list = list_of_hits({true, false, true});
  EXPECT_EQ(precision_at(list, 1), 1);
  EXPECT_EQ(precision_at(list, 2), 0.5);
  EXPECT_EQ(precision_at(list, 10), 0.2);
}

}  // namespace
}  // namespace shapegauge
