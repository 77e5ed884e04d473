#include <gtest/gtest.h>

#include "shapegauge/core/base/number_text.h"

namespace shapegauge {

namespace {

TEST(NumberText, HasTwoDigitsAndNoShortExponent) {
  EXPECT_EQ(two_digits(0.1234), "0.12");
  EXPECT_EQ(two_digits(99.4), "99");
  EXPECT_EQ(two_digits(99.9), "100");
  EXPECT_EQ(two_digits(-1234.5), "-1234");
  EXPECT_EQ(two_digits(1e9), "1e+09");
}

}  // namespace

}  // namespace shapegauge
