#include <gtest/gtest.h>

#include "shapegauge/metrics/measures/r_precision.h"

namespace shapegauge {
namespace {

TEST(RPrecision, IsThePrecisionAtRankR) {
  EXPECT_DOUBLE_EQ(r_precision_definition.value(list_of_hits({true, false, true, true})), 2.0 / 3);
}

}  // namespace
}  // namespace shapegauge
