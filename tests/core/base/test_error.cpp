#include <gtest/gtest.h>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

namespace {

TEST(Printable, ControlCharactersAreReplacedAndTheRestIsCut) {
  EXPECT_EQ(printable("", 3), "");
  EXPECT_EQ(printable("abc", 3), "abc");
  EXPECT_EQ(printable("abcd", 3), "abc...");
  EXPECT_EQ(printable(std::string_view("a\n\0\x7f", 4), 10), "a???");
  EXPECT_EQ(printable("\xC3\xA9", 10), "\xC3\xA9");
}

}  // namespace

}  // namespace shapegauge
