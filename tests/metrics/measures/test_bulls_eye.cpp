#include <gtest/gtest.h>

#include "shapegauge/metrics/measures/bulls_eye.h"

namespace shapegauge {
namespace {

TEST(BullsEye, CountsTheQueryUnderEveryProtocol) {
  // A class of three: six ranks with the query.
  EXPECT_DOUBLE_EQ(bulls_eye(list_of_hits({false, true, false, false, false, true})), 2.0 / 3);
  EXPECT_DOUBLE_EQ(bulls_eye(list_of_hits({true, false, true, false, false, false, true}, true)), 2.0 / 3);
}

}  // namespace
}  // namespace shapegauge
