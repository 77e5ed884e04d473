#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "shapegauge/experiments/files/csv.h"
#include "tests/experiments/input_error.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Csv, CellsStandBetweenCommas) {
  EXPECT_THAT(split_csv_line("a, b ,,c d", "x"), ElementsAre("a", "b", "", "c d"));
  EXPECT_THAT(split_csv_line("", "x"), ElementsAre(""));
  EXPECT_THAT(split_csv_line("a,", "x"), ElementsAre("a", ""));
  EXPECT_THAT(split_csv_line(",", "x"), ElementsAre("", ""));
}

TEST(Csv, QuotedCellsHoldCommasAndQuotationMarks) {
  EXPECT_THAT(split_csv_line(R"("a,b", "say ""no""" ,"",c"d)", "x"), ElementsAre("a,b", R"(say "no")", "", R"(c"d)"));
}

TEST(Csv, BadQuotationIsAnErrorWithItsPlace) {
  EXPECT_THAT(input_error_of([] { split_csv_line(R"(a,"b)", "f.csv:7"); }),
              AllOf(HasSubstr("f.csv:7: "), HasSubstr("not closed")));
  EXPECT_THAT(input_error_of([] { split_csv_line(R"("a"b,c)", "f.csv:7"); }),
              AllOf(HasSubstr("f.csv:7: "), HasSubstr(R"("b" follows)")));
}

TEST(Csv, RowsKnowTheirLinesAndEmptyLinesDoNotCount) {
  const auto rows = parse_csv("\xEF\xBB\xBFid,x\r\n\r\na,1\n  \nb,2", "f");
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_THAT(rows[0].cells, ElementsAre("id", "x"));
  EXPECT_EQ(rows[0].line, 1U);
  EXPECT_THAT(rows[1].cells, ElementsAre("a", "1"));
  EXPECT_EQ(rows[1].line, 3U);
  EXPECT_EQ(rows[2].line, 5U);
  EXPECT_THAT(input_error_of([] { parse_csv("a\n\"b", "f"); }), HasSubstr("f:2: "));
}

RC_GTEST_PROP(Csv, CellsReadBackAsTheyWere, ()) {
  const auto cell = rc::gen::container<std::string>(rc::gen::element('a', ',', '"', ' ', '\t', '\xC3', '\xA9'));
  const auto cells = *rc::gen::nonEmpty(rc::gen::container<std::vector<std::string>>(cell));
  std::string line = csv_line(cells);
  RC_ASSERT(line.ends_with('\n'));
  line.pop_back();
  RC_ASSERT(split_csv_line(line, "x") == cells);
}

}  // namespace

}  // namespace shapegauge
