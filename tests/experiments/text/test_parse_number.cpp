#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <string>

#include "shapegauge/experiments/text/parse_number.h"

namespace shapegauge {
namespace {

TEST(ParseNumber, TakesTheUsualSpellings) {
  EXPECT_EQ(parse_number("1"), 1.0);
  EXPECT_EQ(parse_number("+.5"), 0.5);
  EXPECT_EQ(parse_number("-2e-3"), -2e-3);
  EXPECT_EQ(parse_number("1.5E+02"), 150.0);
  EXPECT_EQ(parse_number("inf"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_number("-Infinity"), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(parse_number("nan").value()));
}

TEST(ParseNumber, RefusesAllElse) {
  for (const char* const word : {"", "+", "+-1", "++1", "1,5", "1 ", " 1", "0x10", "one", "1e", "1e999", "T1"}) {
    EXPECT_FALSE(parse_number(word)) << word;
  }
}

RC_GTEST_PROP(ParseNumber, ReadsBackWhatIsWrittenShortest, (double value)) {
  RC_ASSERT(parse_number(fmt::format("{}", value)) == value);
}

}  // namespace
}  // namespace shapegauge
