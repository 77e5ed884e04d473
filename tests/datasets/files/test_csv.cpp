// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "shapegauge/datasets/files/csv.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// Cells of a one-row text.
std::vector<std::string> cells_of(const std::string& text, char separator = ',') {
  CsvReader reader(text, "f.csv", separator);
  const auto row = reader.next();
  return row && !reader.next() ? row->cells : std::vector<std::string>{"not one row"};
}

std::string csv_error_of(const std::string& text) {
  return test::input_error_of([&] { parse_csv(text, "f.csv"); });
}

TEST(CsvParser, SplitsCellsAtCommas) {
  EXPECT_THAT(cells_of("a, b ,,c d"), ElementsAre("a", "b", "", "c d"));
  EXPECT_THAT(cells_of("a,"), ElementsAre("a", ""));
  EXPECT_THAT(parse_csv("", "f.csv"), testing::IsEmpty());
}

TEST(CsvParser, AcceptsSemicolonsAndTabsAsSeparators) {
  EXPECT_THAT(cells_of("a; \"b;c\" ;d,e", ';'), ElementsAre("a", "b;c", "d,e"));
  EXPECT_THAT(cells_of("a\t\tb c\t", '\t'), ElementsAre("a", "", "b c", ""));
}

TEST(CsvParser, AcceptsCommasAndQuotesInQuotedCells) {
  EXPECT_THAT(cells_of(R"("a,b", "say ""no""" ,"",c"d)"), ElementsAre("a,b", R"(say "no")", "", R"(c"d)"));
}

TEST(CsvParser, AcceptsLineBreaksInQuotedCells) {
  const auto rows = parse_csv("id,\"two\r\nlines\"\r\n\"a\n\n\"\"b\",c\nd,e\n", "f");
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_THAT(rows[0].cells, ElementsAre("id", "two\r\nlines"));
  EXPECT_THAT(rows[1].cells, ElementsAre("a\n\n\"b", "c"));
  EXPECT_EQ(rows[1].line, 3U);
  EXPECT_EQ(rows[2].line, 6U);
  EXPECT_EQ(csv_cell("a\nb"), "\"a\nb\"");
  EXPECT_EQ(csv_cell("a\rb"), "\"a\rb\"");
}

TEST(CsvParser, RejectsInvalidQuotingWithItsLocation) {
  EXPECT_THAT(csv_error_of("x\na,\"b\nc"), AllOf(HasSubstr("f.csv:2: "), HasSubstr("not closed")));
  EXPECT_THAT(csv_error_of("x\n\"a\"b,c"), AllOf(HasSubstr("f.csv:2: "), HasSubstr(R"("b" follows)")));
}

TEST(CsvParser, GivesRowsTheirLineNumbersAndSkipsEmptyLines) {
  const auto rows = parse_csv("\xEF\xBB\xBFid,x\r\n\r\na,1\n  \nb,2", "f");
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_THAT(rows[0].cells, ElementsAre("id", "x"));
  EXPECT_EQ(rows[0].line, 1U);
  EXPECT_THAT(rows[1].cells, ElementsAre("a", "1"));
  EXPECT_EQ(rows[1].line, 3U);
  EXPECT_EQ(rows[2].line, 5U);
  EXPECT_THAT(test::input_error_of([] { parse_csv("a\n\"b", "f"); }), HasSubstr("f:2: "));
}

TEST(CsvParser, SkipsRowsOfUnquotedEmptyCells) {
  const auto rows = parse_word_table("id;class\n;\na;1\n ; \n\"\";\n;\n", "f");
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_THAT(rows[1].cells, ElementsAre("a", "1"));
  EXPECT_EQ(rows[1].line, 3U);
  EXPECT_THAT(rows[2].cells, ElementsAre("", "")) << "one is quoted";
}

TEST(CsvParser, AcceptsCarriageReturnsAtLineEnds) {
  const auto rows = parse_word_table("\rid,x\r\ra, 1 \r\"b\rc\",2\rd,3", "f");
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_THAT(rows[0].cells, ElementsAre("id", "x"));
  EXPECT_THAT(rows[1].cells, ElementsAre("a", "1"));
  EXPECT_THAT(rows[2].cells, ElementsAre("b\rc", "2"));
  EXPECT_THAT(rows[3].cells, ElementsAre("d", "3"));
  EXPECT_EQ(rows[3].line, 7U);
}

TEST(CsvParser, RejectsRowsOfMoreThanAMillionCells) {
  std::string text = "a,b\n";
  for (std::size_t i = 0; i < max_csv_cells; ++i) text += "0,";
  EXPECT_THAT(test::input_error_of([&] { parse_csv(text, "f"); }),
              HasSubstr("f:2: the row has more than 1000000 cells"));
}

TEST(CsvParser, DetectsTheSeparatorFromTheFirstLine) {
  for (const char* text : {"id,x\na,1\n", "id;x\na;1\n", "id\tx\na\t1\n"}) {
    const auto rows = parse_word_table(text, "f");
    ASSERT_EQ(rows.size(), 2U) << text;
    EXPECT_THAT(rows[1].cells, ElementsAre("a", "1")) << text;
  }
  EXPECT_THAT(parse_word_table("id\na\n", "f")[1].cells, ElementsAre("a"));
  EXPECT_THAT(test::input_error_of([] { parse_word_table("id;x\na,1;2\nb\n", "f"); }),
              HasSubstr("f:3: 1 cell where the first row has 2"));
}

TEST(CsvParser, FindsColumnsInAnyCase) {
  const CsvRow header{.cells = {"x", "LABEL", "Class"}, .line = 1};
  EXPECT_EQ(find_column(header, class_column_names), 1U);
  EXPECT_EQ(find_column(header, std::array<std::string_view, 1>{"id"}), std::nullopt);
  EXPECT_THAT(test::input_error_of([&] { find_class_column(header, "f"); }),
              HasSubstr("f:1: the columns \"LABEL\" and \"Class\" both name classes"));
  EXPECT_EQ(find_class_column({.cells = {"id", "Class"}, .line = 1}, "f"), 1U);
}

TEST(CsvWriter, EscapesFormulasWithAnApostrophe) {
  for (const std::string text : {"=1+1", "@x", "+cmd|' /C calc'!A0", "-x", "'=1", "''-5", "=a,b"}) {
    EXPECT_THAT(csv_cell(text), testing::MatchesRegex("\"?'.*")) << text;
    EXPECT_EQ(parse_csv(csv_line({text}), "x").at(0).cells, std::vector{text});
  }
  for (const std::string text : {"-0.5", "+1e3", "-inf", "-1.5 [-2, -1]", "=", "-", "a=b", "'quoted'"}) {
    EXPECT_EQ(csv_cell(text).find(text), text.find(',') == std::string::npos ? 0U : 1U) << text;
    EXPECT_EQ(parse_csv(csv_line({text}), "x").at(0).cells, std::vector{text});
  }
}

TEST(CsvWriter, WrittenEmptyCellsAreReadBackUnchanged) {
  EXPECT_EQ(csv_line({"", ""}), "\"\",\n");
  EXPECT_EQ(cells_of(csv_line({""})), std::vector<std::string>{""});
}

RC_GTEST_PROP(CsvWriter, WrittenCellsAreReadBackUnchanged, ()) {
  const auto cell =
      rc::gen::container<std::string>(rc::gen::element('a', ',', '"', ' ', '\t', '\n', '\r', '\xC3', '\xA9'));
  const auto cells = *rc::gen::nonEmpty(rc::gen::container<std::vector<std::string>>(cell));
  RC_ASSERT(cells_of(csv_line(cells)) == cells);
}

}  // namespace

}  // namespace shapegauge
