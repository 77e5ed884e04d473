#include <gtest/gtest.h>

#include "shapegauge/metrics/measures/area_under_curve.h"

namespace shapegauge {
namespace {

TEST(AreaUnderCurve, IsThatOfTrapezia) {
  // Precision 1, 2/3, 1/2 at recall 1/3, 2/3, 1.
  const RankedList list = list_of_hits({true, false, true, false, false, true});
  EXPECT_DOUBLE_EQ(area_under_curve(list), (1 + (1 + 2.0 / 3) / 2 + (2.0 / 3 + 0.5) / 2) / 3);
}

TEST(AreaUnderCurve, IsOneForAPerfectList) { EXPECT_EQ(area_under_curve(list_of_hits({true, true, false})), 1); }

}  // namespace
}  // namespace shapegauge
