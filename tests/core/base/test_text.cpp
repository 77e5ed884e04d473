// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <string>

#include "shapegauge/core/base/text.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;

TEST(TextLines, EndWithLineFeedOrCarriageReturnAndLineFeed) {
  EXPECT_THAT(split_lines("a\nb\r\n\nc"), ElementsAre("a", "b", "", "c"));
  EXPECT_THAT(split_lines("a\n"), ElementsAre("a"));
  EXPECT_THAT(split_lines("a\r\rb\r"), ElementsAre("a", "", "b"));
  EXPECT_THAT(split_lines("a\rb\n"), ElementsAre("a\rb"));
  EXPECT_THAT(split_lines("\n"), ElementsAre(""));
  EXPECT_THAT(split_lines(""), ElementsAre());
}

TEST(TextLines, ExcludeAByteOrderMark) {
  EXPECT_THAT(split_lines("\xEF\xBB\xBFx\ny"), ElementsAre("x", "y"));
  EXPECT_THAT(split_lines("\xEF\xBB\xBF"), ElementsAre());
}

TEST(TextLines, TrimmingRemovesSpacesAndTabsAtBothEnds) {
  EXPECT_EQ(trim(" \ta b\t "), "a b");
  EXPECT_EQ(trim(" \t"), "");
  EXPECT_EQ(trim(""), "");
}

TEST(LowerCase, ChangesAsciiCapitalsOnly) {
  EXPECT_EQ(lower_case(".OFF"), ".off");
  EXPECT_EQ(lower_case("AZaz09@[`{ -"), "azaz09@[`{ -");
  EXPECT_EQ(lower_case("\xC3\x89"), "\xC3\x89");
  EXPECT_EQ(lower_case(""), "");
}

TEST(ParseNumber, AcceptsDecimalsExponentsInfinityAndNaN) {
  EXPECT_EQ(parse_number("1"), 1.0);
  EXPECT_EQ(parse_number("+.5"), 0.5);
  EXPECT_EQ(parse_number("-2e-3"), -2e-3);
  EXPECT_EQ(parse_number("1.5E+02"), 150.0);
  EXPECT_EQ(parse_number("inf"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_number("-Infinity"), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(parse_number("nan").value()));
}

TEST(ParseNumber, RejectsTextThatIsNotANumber) {
  for (const char* const word : {"", "+", "+-1", "++1", "1,5", "1 ", " 1", "0x10", "one", "1e", "1e999", "T1"}) {
    EXPECT_FALSE(parse_number(word)) << word;
  }
}

RC_GTEST_PROP(ParseNumber, RestoresNumbersFromTheirShortestTextExactly, (double value)) {
  RC_ASSERT(parse_number(fmt::format("{}", value)) == value);
}

TEST(CountText, UsesSingularAndPlural) {
  EXPECT_EQ(count_text(1, "row", "rows"), "1 row");
  EXPECT_EQ(count_text(0, "row", "rows"), "0 rows");
  EXPECT_EQ(count_text(1234, "row", "rows"), "1234 rows");
}

TEST(TwoDigits, KeepTwoSignificantDigitsOrTheIntegerPart) {
  EXPECT_EQ(two_digits(0.1234), "0.12");
  EXPECT_EQ(two_digits(99.4), "99");
  EXPECT_EQ(two_digits(99.9), "100");
  EXPECT_EQ(two_digits(-1234.5), "-1234");
  EXPECT_EQ(two_digits(1e9), "1e+09");
}

TEST(PlainNumber, AvoidsExponentsExceptForHugeNumbers) {
  const std::vector<std::pair<double, std::string>> cases{{0, "0"},
                                                          {6, "6"},
                                                          {1.7320508, "1.73205"},
                                                          {-1234567, "-1234570"},
                                                          {0.00012345678, "0.000123457"},
                                                          {999999.7, "1000000"},
                                                          {1e160, "1e+160"}};
  for (const auto& [number, text] : cases) EXPECT_EQ(plain_number(number, 6), text);
}

TEST(QuotedWord, ReplacesLineEndsAndControlCharacters) {
  EXPECT_EQ(quoted_word("T12"), "\"T12\"");
  EXPECT_EQ(quoted_word(""), "\"\"");
  EXPECT_EQ(quoted_word(std::string_view("a\nb\0c\x7f", 6)), "\"a?b?c?\"");
  EXPECT_EQ(quoted_word("\xC3\xA9"), "\"\xC3\xA9\"");
}

TEST(QuotedWord, IsCutAfterFortyBytes) {
  EXPECT_EQ(quoted_word(std::string(40, 'x')), '"' + std::string(40, 'x') + '"');
  EXPECT_EQ(quoted_word(std::string(41, 'x')), '"' + std::string(40, 'x') + "...\"");
}

}  // namespace

}  // namespace shapegauge
