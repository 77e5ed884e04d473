#include <gtest/gtest.h>

#include "shapegauge/metrics/measures/average_precision.h"

namespace shapegauge {
namespace {

// The textbook example of Manning, Raghavan and Schuetze's kind: hits at ranks 1, 3, 6.
TEST(AveragePrecision, IsTheMeanPrecisionAtTheHits) {
  EXPECT_DOUBLE_EQ(average_precision(list_of_hits({true, false, true, false, false, true})),
                   (1.0 / 1 + 2.0 / 3 + 3.0 / 6) / 3);
}

TEST(AveragePrecision, IsOneForAPerfectList) {
  EXPECT_EQ(average_precision(list_of_hits({true, true, true, false, false})), 1);
}

}  // namespace
}  // namespace shapegauge
