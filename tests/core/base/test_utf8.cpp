// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shapegauge/core/base/utf8.h"

namespace shapegauge {

namespace {

TEST(Utf8Text, EscapesInvalidBytes) {
  EXPECT_EQ(with_escaped_bytes("St\xe4hl.off"), "St\\xE4hl.off");
  EXPECT_EQ(with_escaped_bytes("\xff\xc3"), "\\xFF\\xC3");
  EXPECT_EQ(with_escaped_bytes("\xed\xa0\x80"), "\\xED\\xA0\\x80") << "a surrogate";
}

TEST(Utf8Text, KeepsValidText) {
  for (const char* text : {"", "plain", "St\u00e4hl", "\u4e2d\u6587", "\U0001F600", "a\\xE4"}) {
    EXPECT_EQ(with_escaped_bytes(text), text);
  }
}

}  // namespace

}  // namespace shapegauge
