// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <set>
#include <string>
#include <vector>

#include "shapegauge/datasets/files/matrix_files.h"
#include "shapegauge/datasets/files/text_matrices.h"
#include "tests/datasets/files/random_matrices.h"
#include "tests/datasets/files/write_matrix.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using test::expect_refused;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

LabelledTable read_csv(const std::string& text) {
  const TemporaryFolder folder;
  return read_matrix(folder.file("m.csv", text), TableShape::square);
}

std::string csv_error(const std::string& text) {
  return test::input_error_of([&] { read_csv(text); });
}

DistanceMatrix text_example() { return DistanceMatrix{{0, 1.5}, {-2.25, std::numeric_limits<double>::infinity()}}; }

TEST(CsvMatrix, ReadsIdsOfTheHeaderRowAndTheFirstColumn) {
  for (const char* const text :
       {"id,T1,T2\nT1,0,1.5\nT2,-2.25,inf\n", ",T1,T2\r\n\"T1\", 0 ,1.50\r\n\r\nT2,-2.25,inf"}) {
    const LabelledTable result = read_csv(text);
    EXPECT_EQ(result.numbers, text_example());
    EXPECT_THAT(result.row_ids, ElementsAre("T1", "T2"));
  }
}

TEST(CsvMatrix, AcceptsNumbersAsIds) {
  for (const std::string corner : {"id", ""}) {
    const LabelledTable matrix = read_csv(corner + ",7,5\n7,0,1\n5,2,0\n");
    EXPECT_THAT(matrix.row_ids, ElementsAre("7", "5"));
    EXPECT_EQ(matrix.numbers, (Eigen::Matrix2d{{0, 1}, {2, 0}}));
  }
}

TEST(CsvMatrix, AcceptsASeparatorAtTheEndOfRows) {
  EXPECT_EQ(read_csv("0,1.5,\n-2.25,inf,\n").numbers, text_example());
  EXPECT_EQ(read_csv("id,a,b,\na,0,1.5,\nb,-2.25,inf,\n").numbers, text_example());
  EXPECT_THAT(csv_error("0,1,\n1\n"), HasSubstr("m.csv:2"));
}

TEST(CsvMatrix, AcceptsAFirstLineThatDeclaresTheSeparator) {
  EXPECT_EQ(read_csv("sep=;\r\n0;1.5\r\n-2.25;inf\r\n").numbers, text_example());
  EXPECT_THAT(read_csv("sep=,\nid,a,b\na,0,1.5\nb,-2.25,inf\n").row_ids, ElementsAre("a", "b"));
  EXPECT_THAT(csv_error("sep=;\n0;1\n1;x\n"), HasSubstr("m.csv:3"));
}

// The first row of distances, unless it may be the ids: whole numbers that differ.
TEST(CsvMatrix, AcceptsAnEmptyDiagonal) {
  EXPECT_EQ(read_csv(",0.5,3\n0.5,,2\n3,2,\n").numbers, (DistanceMatrix{{0, 0.5, 3}, {0.5, 0, 2}, {3, 2, 0}}));
  EXPECT_EQ(read_csv("NA,3,3\n3,NA,2\n3,2,NA\n").numbers, (DistanceMatrix{{0, 3, 3}, {3, 0, 2}, {3, 2, 0}}));
  EXPECT_THAT(csv_error("0,1,2\n1,0,\n2,3,0\n"), HasSubstr("m.csv:2"));
}

TEST(CsvMatrix, AcceptsSemicolonsOrTabsAsSeparators) {
  for (const char* const text : {"0;1.5\n-2.25;inf\n", "0\t1.5\n-2.25\tinf\n", "0; 1.5\r\n-2.25; inf\r\n"}) {
    EXPECT_EQ(read_csv(text).numbers, text_example()) << text;
  }
  EXPECT_THAT(read_csv("\tT1\tT2\nT1\t0\t1.5\nT2\t-2.25\tinf\n").row_ids, ElementsAre("T1", "T2"));
  EXPECT_THAT(read_csv("id;\"T,1\";T2\n\"T,1\";0;1.5\nT2;-2.25;inf\n").row_ids, ElementsAre("T,1", "T2"));
  EXPECT_THAT(read_csv("id,T;1,T2\nT;1,0,1.5\nT2,-2.25,inf\n").row_ids, ElementsAre("T;1", "T2")) << "commas as before";
}

TEST(CsvMatrix, HasNoIdsWithoutAHeader) {
  const LabelledTable result = read_csv("0,1.5\n-2.25,inf\n");
  EXPECT_EQ(result.numbers, text_example());
  EXPECT_THAT(result.row_ids, IsEmpty());
}

TEST(CsvMatrix, AcceptsCarriageReturnsAtLineEnds) {
  const LabelledTable matrix = read_csv("id,a,b\ra,0,1\rb,2,0\r");
  EXPECT_THAT(matrix.row_ids, ElementsAre("a", "b"));
  EXPECT_EQ(matrix.numbers, (Eigen::Matrix2d{{0, 1}, {2, 0}}));
}

TEST(CsvMatrix, ErrorMessagesGiveTheLineNumber) {
  expect_refused({{"id,a,b\na,0,x\nb,1,0\n", "m.csv:2: \"x\" is not a number (number 2"},
                  {"id,a,b\na,0,\nb,1,0\n", "m.csv:2: \"\" is"},
                  {"id,a,b\nb,0,1\na,1,0\n", "m.csv:2: "},
                  {"id,a,a\na,0,1\na,1,0\n", "m.csv:1: repeated id \"a\""},
                  {"id,,a\n,0,1\na,1,0\n", "m.csv:1: "},
                  {"id,a,b\na,0,1\nb,1\n", "m.csv:3: expected 2"},
                  {"id,a,b\na,0,1\nb,1,0\nc,1,1\n", "m.csv:4: "},
                  {"0|1\n1|0\n", "m.csv:1: \"0|1\""},
                  {"0 1\n1 0\n", "m.csv:1: \"0 1\""},
                  {"# distances\n0,1\n1,0\n", "m.csv:1: "},
                  {"# a, b, c\n0,1\n1,0\n", "m.csv:1: "},
                  {"id,a,b\na,0,1\n", "m.csv: expected a square"},
                  {"id,a,b\na,0\n", "m.csv: the header row has 2"},
                  {"id,a\na\n", "m.csv:2: "},
                  {"id\n", "m.csv: "},
                  {"\n", "m.csv: "},
                  {"0,1\n1,\"0\n", "m.csv:2: "},
                  {"0;1,5\n2,5;0\n", "decimal points"},
                  {"", "empty"}},
                 read_csv);
}

TEST(CsvMatrix, IsRejectedIfTruncatedBeforeTheLastCell) {
  const std::string valid = "id,a,\"b,c\"\na,0,1.5\n\"b,c\",1.5,0\n";
  for (std::size_t length = 0; length + 2 < valid.size(); ++length) {
    EXPECT_THAT(csv_error(valid.substr(0, length)), HasSubstr("m.csv")) << length;
  }
  EXPECT_EQ(csv_error(valid.substr(0, valid.size() - 2)), "no error") << "the diagonal may be empty";
  EXPECT_EQ(csv_error(valid.substr(0, valid.size() - 1)), "no error");
}

RC_GTEST_PROP(CsvMatrix, IsReadBackAsWritten, ()) {
  const TemporaryFolder folder;
  const DistanceMatrix written = *square_matrices() / 3;
  const auto id = rc::gen::nonEmpty(rc::gen::container<std::string>(rc::gen::element('1', 'T', ',', '"', ' ', '\t')));
  std::set<std::string> ids;
  while (static_cast<Eigen::Index>(ids.size()) < written.rows()) ids.insert(*id + std::to_string(ids.size()));
  const std::vector<std::string> listed(ids.begin(), ids.end());
  write_csv_matrix(folder.path() / "m.csv", written, listed);
  const LabelledTable result = read_matrix(folder.path() / "m.csv", TableShape::square);
  RC_ASSERT(result.numbers == written);
  RC_ASSERT(result.row_ids == listed);
  RC_ASSERT(result.column_ids == listed);
}

DistanceMatrix read_text(const std::string& text) {
  const TemporaryFolder folder;
  return read_matrix(folder.file("m.txt", text), TableShape::square).numbers;
}

std::string text_error(const std::string& text) {
  return test::input_error_of([&] { read_text(text); });
}

TEST(TextMatrix, AcceptsSemicolonsOrCommasBetweenNumbers) {
  for (const char* const text : {"0;1.5\n-2.25;inf\n", "# distances\n0, 1.5\n-2.25, inf\n", "0\t1.5\n-2.25\tinf\n"}) {
    EXPECT_EQ(parse_text_matrix(text, "m.txt", TableShape::square), text_example()) << text;
  }
}

TEST(TextMatrix, ReadsOneRowPerLine) {
  const DistanceMatrix expected{{0, 1.5}, {-2.25, std::numeric_limits<double>::infinity()}};
  EXPECT_EQ(read_text("0 1.5\n-2.25 inf\n"), expected);
  EXPECT_EQ(read_text("\xEF\xBB\xBF# distances\r\n\r\n\t0.0  1.50 \r\n  # more\r\n-225e-2\tInf"), expected);
}

TEST(TextMatrix, AcceptsASingleNumber) { EXPECT_EQ(read_text("0"), DistanceMatrix::Zero(1, 1)); }

TEST(TextMatrix, ErrorMessagesGiveTheLineNumber) {
  expect_refused({{"0 1\n1 x\n", "m.txt:2: \"x\" is not a number (number 2"},
                  {"0 1\n\n1\n", "m.txt:3: expected 2"},
                  {"0 1\n1 0 2\n", "m.txt:2: expected 2"},
                  {"0 1\n1 0\n2 3\n", "m.txt:3: expected a square"},
                  {"0 1 2\n1 0 2\n", "m.txt: expected a square"},
                  {"0,,1\n1,0,1\n1,1,0\n", "m.txt:1: \"\""},
                  {"0;1,5\n1,5;0\n", "m.txt:1: \"1,5\""},
                  {"0,0 1,5\n1,5 0,0\n", "m.txt:1: \"0 1\""},
                  {"# nothing\n", "m.txt: "},
                  {"", "empty"}},
                 read_text);
}

TEST(TextMatrix, IsRejectedIfTruncatedUnlessStillSquare) {
  // Of two models: a row of three numbers would be condensed distances.
  const std::string valid = "# two models\n0 1.25e-1\n1.25e-1 0\n";
  const std::size_t first_number = valid.find('0');
  for (std::size_t length = 0; length < valid.size(); ++length) {
    // A single number is a matrix; the final newline is optional.
    const bool alone = length == first_number + 1 || length == first_number + 2;
    const bool whole = length + 1 == valid.size();
    EXPECT_THAT(text_error(valid.substr(0, length)), HasSubstr(alone || whole ? "no error" : "m.txt")) << length;
  }
}

LabelledTable table_of(const std::string& text) { return parse_csv_table(text, "t.csv"); }

const DistanceMatrix wide_numbers = Eigen::Matrix<double, 2, 3>{{0, 1, 4}, {2, 0, 6}};

TEST(CsvTable, MayHaveDifferentIdsOfRowsAndColumns) {
  // Without ids, with those of columns, of rows, and of both: by the first cells of the first two rows.
  const auto expect_table = [](const std::string& text, const std::vector<std::string>& rows,
                               const std::vector<std::string>& columns) {
    const LabelledTable table = table_of(text);
    EXPECT_EQ(table.numbers, wide_numbers) << text;
    EXPECT_EQ(table.row_ids, rows) << text;
    EXPECT_EQ(table.column_ids, columns) << text;
  };
  expect_table("0,1,4\n2,0,6\n", {}, {});
  expect_table("x,y,z\n0,1,4\n2,0,6\n", {}, {"x", "y", "z"});
  expect_table("a,0,1,4\nb,2,0,6\n", {"a", "b"}, {});
  expect_table("id,x,y,z\na,0,1,4\nb,2,0,6\n", {"a", "b"}, {"x", "y", "z"});
  expect_table(";x;y;z\r\na;0;1;4\r\nb;2;0;6", {"a", "b"}, {"x", "y", "z"});
  expect_table("shape\tx\ty\tz\na\t0\t1\t4\nb\t2\t0\t6\n", {"a", "b"}, {"x", "y", "z"});
}

TEST(CsvTable, ErrorMessagesGiveTheLineNumber) {
  expect_refused({{"0,1\n2\n", "t.csv:2:"},
                  {"0,1\n2,x\n", "t.csv:2:"},
                  {"id,x,y\na,0\nb,1\n", "t.csv:1:"},
                  {"a,0\na,1\n", "t.csv: "},
                  {"id,x\n,0\n", "t.csv: "},
                  {"x,y\n", "t.csv: "},
                  {"0 1 4\n2 0 6\n", "t.csv:2: \"2 0 6\""},
                  {"0|1|4\n2|0|6\n", "t.csv:2: \"2|0|6\""},
                  {"x\n0 1 4\n", "t.csv:2: \"0 1 4\""},
                  {"0 | 1 | 4\n", "t.csv:1: "},
                  {"x,y,Label\n0,1,4\n2,0,6\n", "t.csv:1: the column \"Label\" has classes"}},
                 table_of);
  EXPECT_EQ(table_of("label,x\na,0\nb,1\n").row_ids, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(table_of("my feature\n1\n2\n").column_ids, std::vector<std::string>{"my feature"});
}

RC_GTEST_PROP(CsvTable, OfAnySizeIsReadBackAsWritten, ()) {
  const DistanceMatrix square = *square_matrices();
  const Eigen::Index rows = *rc::gen::inRange<Eigen::Index>(1, square.rows() + 1);
  const DistanceMatrix written = square.topRows(rows);
  const bool has_row_ids = *rc::gen::arbitrary<bool>();
  const bool has_column_ids = *rc::gen::arbitrary<bool>();
  std::vector<std::string> row_ids;
  std::vector<std::string> column_ids;
  std::string text = has_column_ids && has_row_ids ? "id" : "";
  for (Eigen::Index j = 0; has_column_ids && j < written.cols(); ++j) {
    column_ids.push_back(fmt::format("c{}", j));
    text += (j > 0 || has_row_ids ? "," : "") + column_ids.back();
  }
  if (has_column_ids) text += "\n";
  for (Eigen::Index i = 0; i < rows; ++i) {
    if (has_row_ids) {
      row_ids.push_back(fmt::format("r {}", i));
      text += row_ids.back() + ",";
    }
    text += fmt::format("{}\n", fmt::join(written.row(i).begin(), written.row(i).end(), ","));
  }
  const LabelledTable table = table_of(text);
  RC_ASSERT(table.numbers == written);
  RC_ASSERT(table.row_ids == row_ids);
  RC_ASSERT(table.column_ids == column_ids);
}

TEST(TextMatrix, RejectsRowsOfDifferentLength) {
  EXPECT_EQ(parse_text_matrix("0 1 4\n2 0 6\n", "t.txt", TableShape::any), wide_numbers);
  EXPECT_THAT(test::input_error_of([] { parse_text_matrix("0 1 4\n2 0\n", "t.txt", TableShape::any); }),
              HasSubstr("t.txt:2:"));
}

}  // namespace

}  // namespace shapegauge
