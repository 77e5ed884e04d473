// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shapegauge/core/base/error.h"

namespace shapegauge {

namespace {

TEST(PrintableText, ReplacesControlCharactersAndCutsLongText) {
  EXPECT_EQ(printable("", 3), "");
  EXPECT_EQ(printable("abc", 3), "abc");
  EXPECT_EQ(printable("abcd", 3), "abc...");
  EXPECT_EQ(printable(std::string_view("a\n\0\x7f", 4), 10), "a???");
  EXPECT_EQ(printable("\xC3\xA9", 10), "\xC3\xA9");
}

TEST(PrintableText, ReplacesTerminalEscapes) {
  EXPECT_EQ(printable("a\x1b[31mb"), "a?[31mb");
  EXPECT_EQ(printable("\xC2\x9B"
                      "31m"),
            "?31m")
      << "the same sequence begun by one character, in UTF-8";
  EXPECT_EQ(printable("\x9B"
                      "31m"),
            "?31m")
      << "and in Latin 1";
  EXPECT_EQ(printable("\xC2\xA0"), "\xC2\xA0");
}

TEST(PrintableText, ReplacesBidirectionalControls) {
  // NOLINTNEXTLINE(misc-misleading-bidirectional): the characters are escaped
  EXPECT_EQ(printable("a\u202Eb\u2066c\u200Fd\u061C"), "a?b?c?d?");
  EXPECT_EQ(printable("\u200D\u2010\u2029\u202F\u2065\u206A"), "\u200D\u2010\u2029\u202F\u2065\u206A");
}

TEST(PrintableText, ReplacesInvalidUtf8AndCutsBetweenCharacters) {
  EXPECT_EQ(printable("caf\xE9"), "caf?");
  EXPECT_EQ(printable("\xE0\x80\x80"), "???");
  EXPECT_EQ(printable("\xED\xA0\x80"), "???");
  EXPECT_EQ(printable("\xF0\x9F\x90\x9F"), "\xF0\x9F\x90\x9F");
  EXPECT_EQ(printable("\xF4\x90\x80\x80"), "????");
  EXPECT_EQ(printable("\xE2\x82"), "??");
  EXPECT_EQ(printable("a\xC3\xA9", 2), "a...");
}

TEST(InputError, ReplacesControlCharactersInItsMessage) {
  EXPECT_STREQ(InputError("cannot read a\x1b]0;title\n.off").what(), "cannot read a?]0;title?.off");
}

}  // namespace

}  // namespace shapegauge
