#include <gtest/gtest.h>

#include "shapegauge/experiments/text/quoted_word.h"

namespace shapegauge {
namespace {

TEST(QuotedWord, StandsInQuotationMarksOnOneLine) {
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
