// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "app/terminal.h"

namespace shapegauge {

namespace {

TEST(ProgressText, ShowsRateAndRemainingTime) {
  EXPECT_EQ(progress_text("signatures", 120, 600, 60), "signatures 120/600  2/s  4:00 left");
  EXPECT_EQ(progress_text("signatures", 1, 125, 0.5), "signatures 1/125  2/s  1:02 left");
}

TEST(ProgressText, OmitsAnUnknownRate) {
  EXPECT_EQ(progress_text("models", 0, 9, 3), "models 0/9");
  EXPECT_EQ(progress_text("models", 9, 9, 0), "models 9/9");
}

TEST(PrintableLines, KeepLineBreaksAndReplaceTerminalEscapes) {
  EXPECT_EQ(printable_lines("a,b\tc\n\x1b[31md\n"), "a,b\tc\n?[31md\n");
  EXPECT_EQ(printable_lines("e\u202E\n\nf"), "e?\n\nf");
  EXPECT_EQ(printable_lines(""), "");
  EXPECT_EQ(printable_lines("\x1b[1m9.5\x1b[0m\x1b[2J"), "\x1b[1m9.5\x1b[0m?[2J") << "bold cells of tables";
}

}  // namespace

}  // namespace shapegauge
