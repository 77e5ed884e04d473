#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shapegauge/experiments/text/lines.h"

namespace shapegauge {
namespace {

using testing::ElementsAre;

TEST(Lines, EndInLfOrCrLf) {
  EXPECT_THAT(split_lines("a\nb\r\n\nc"), ElementsAre("a", "b", "", "c"));
  EXPECT_THAT(split_lines("a\n"), ElementsAre("a"));
  EXPECT_THAT(split_lines("\n"), ElementsAre(""));
  EXPECT_THAT(split_lines(""), ElementsAre());
}

TEST(Lines, AByteOrderMarkIsNoPartOfTheFirstLine) {
  EXPECT_THAT(split_lines("\xEF\xBB\xBFx\ny"), ElementsAre("x", "y"));
  EXPECT_THAT(split_lines("\xEF\xBB\xBF"), ElementsAre());
}

TEST(Lines, OuterBlanksGo) {
  EXPECT_EQ(without_outer_blanks(" \ta b\t "), "a b");
  EXPECT_EQ(without_outer_blanks(" \t"), "");
  EXPECT_EQ(without_outer_blanks(""), "");
}

}  // namespace
}  // namespace shapegauge
