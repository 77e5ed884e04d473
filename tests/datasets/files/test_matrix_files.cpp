#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <set>
#include <stdexcept>
#include <string>

#include "shapegauge/datasets/files/matrix_files.h"
#include "shapegauge/datasets/files/npy.h"
#include "shapegauge/datasets/files/open_matrix.h"
#include "tests/datasets/files/random_matrices.h"
#include "tests/datasets/files/write_matrix.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using test::TemporaryFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

LabelledDistances read_csv(const std::string& text) {
  const TemporaryFolder folder;
  return read_csv_matrix(folder.file("m.csv", text));
}

std::string csv_error(const std::string& text) {
  return test::input_error_of([&] { read_csv(text); });
}

DistanceMatrix example() {
  DistanceMatrix matrix(2, 2);
  matrix << 0, 1.5, -2.25, std::numeric_limits<double>::infinity();
  return matrix;
}

TEST(CsvMatrix, TakesIdsFromTheHeaderRowAndTheFirstColumn) {
  for (const char* const text :
       {"id,T1,T2\nT1,0,1.5\nT2,-2.25,inf\n", ",T1,T2\r\n\"T1\", 0 ,1.50\r\n\r\nT2,-2.25,inf"}) {
    const LabelledDistances result = read_csv(text);
    EXPECT_EQ(result.distances, example());
    EXPECT_THAT(result.ids, ElementsAre("T1", "T2"));
  }
}

TEST(CsvMatrix, IdsMayBeNumbers) { EXPECT_THAT(read_csv("id,7,5\n7,0,1\n5,1,0\n").ids, ElementsAre("7", "5")); }

TEST(CsvMatrix, TheCornerOfNumericIdsMayBeEmpty) {
  const LabelledDistances matrix = read_csv(",7,5\n7,0,1\n5,2,0\n");
  EXPECT_THAT(matrix.ids, ElementsAre("7", "5"));
  EXPECT_EQ(matrix.distances, (Eigen::Matrix2d{{0, 1}, {2, 0}}));
}

TEST(NumberTable, TheCornerOfNumericIdsMayBeEmpty) {
  const test::TemporaryFolder folder;
  for (const char* corner : {"", "id"}) {
    test::write_text(folder.path() / "x.csv", std::string(corner) + ",1,2,3\n7,0,1,4\n5,2,0,6\n");
    const LabelledTable table = read_number_table(folder.path() / "x.csv");
    EXPECT_THAT(table.row_ids, ElementsAre("7", "5")) << corner;
    EXPECT_THAT(table.column_ids, ElementsAre("1", "2", "3")) << corner;
    EXPECT_EQ(table.numbers, (Eigen::Matrix<double, 2, 3>{{0, 1, 4}, {2, 0, 6}})) << corner;
  }
  test::write_text(folder.path() / "x.csv", "4,1,2\n7,0,1\n");
  EXPECT_EQ(read_number_table(folder.path() / "x.csv").numbers.rows(), 2) << "no corner, no ids";
}

TEST(CsvMatrix, MayHaveSemicolonsOrTabsForCommas) {
  for (const char* const text : {"0;1.5\n-2.25;inf\n", "0\t1.5\n-2.25\tinf\n", "0; 1.5\r\n-2.25; inf\r\n"}) {
    EXPECT_EQ(read_csv(text).distances, example()) << text;
  }
  EXPECT_THAT(read_csv("\tT1\tT2\nT1\t0\t1.5\nT2\t-2.25\tinf\n").ids, ElementsAre("T1", "T2"));
  EXPECT_THAT(read_csv("id;\"T,1\";T2\n\"T,1\";0;1.5\nT2;-2.25;inf\n").ids, ElementsAre("T,1", "T2"));
  EXPECT_THAT(read_csv("id,T;1,T2\nT;1,0,1.5\nT2,-2.25,inf\n").ids, ElementsAre("T;1", "T2")) << "commas as before";
}

TEST(CsvMatrix, ATableOfTabsMayBeATsvFile) {
  const test::TemporaryFolder folder;
  test::write_text(folder.path() / "m.tsv", "\tT1\tT2\nT1\t0\t1.5\nT2\t-2.25\tinf\n");
  EXPECT_EQ(read_distance_matrix(folder.path() / "m.tsv").distances, example());
}

TEST(CsvMatrix, DecimalCommasAreAnError) {
  EXPECT_THAT(csv_error("0;1,5\n2,5;0\n"), AllOf(HasSubstr("m.csv:1: \"1,5\""), HasSubstr("decimal points")));
}

TEST(CsvMatrix, WithoutHeaderThereAreNoIds) {
  const LabelledDistances result = read_csv("0,1.5\n-2.25,inf\n");
  EXPECT_EQ(result.distances, example());
  EXPECT_THAT(result.ids, IsEmpty());
}

TEST(CsvMatrix, AFaultIsOneErrorWithItsLine) {
  EXPECT_THAT(csv_error("id,a,b\na,0,x\nb,1,0\n"), HasSubstr("m.csv:2: \"x\" is not a number (number 2 of the row)"));
  EXPECT_THAT(csv_error("id,a,b\na,0,\nb,1,0\n"), HasSubstr("m.csv:2: \"\" is not a number"));
  EXPECT_THAT(csv_error("id,a,b\nb,0,1\na,1,0\n"),
              AllOf(HasSubstr("m.csv:2: "), HasSubstr("\"b\""), HasSubstr("\"a\"")));
  EXPECT_THAT(csv_error("id,a,a\na,0,1\na,1,0\n"), HasSubstr("m.csv:1: repeated id \"a\""));
  EXPECT_THAT(csv_error("id,a,\na,0,1\n,1,0\n"), HasSubstr("m.csv:1: an id is empty"));
  EXPECT_THAT(csv_error("id,a,b\na,0,1\nb,1\n"), HasSubstr("m.csv:3: expected 2 numbers as in line 2, found 1"));
  EXPECT_THAT(csv_error("id,a,b\na,0,1\nb,1,0\nc,1,1\n"), HasSubstr("m.csv:4: there are more rows than the 2 ids"));
  EXPECT_THAT(csv_error("id,a,b\na,0,1\n"), HasSubstr("m.csv: expected a square distance matrix, found 1 rows of 2"));
  EXPECT_THAT(csv_error("id,a,b\na,0\n"), HasSubstr("m.csv: the header row has 2 ids, but there are 1 rows of 1"));
  EXPECT_THAT(csv_error("id,a\na\n"), HasSubstr("m.csv:2: the row has no numbers"));
  EXPECT_THAT(csv_error("id\n"), HasSubstr("m.csv: the file has no numbers"));
  EXPECT_THAT(csv_error("\n"), HasSubstr("m.csv: the file has no numbers"));
  EXPECT_THAT(csv_error("0,1\n1,\"0\n"), HasSubstr("m.csv:2: "));
  EXPECT_THAT(csv_error(""), HasSubstr("empty"));
}

TEST(CsvMatrix, EveryPrefixReadsOrIsAnInputError) {
  const std::string valid = "id,a,\"b,c\"\na,0,1.5\n\"b,c\",1.5,0\n";
  for (std::size_t length = 0; length + 1 < valid.size(); ++length) {
    EXPECT_THAT(csv_error(valid.substr(0, length)), HasSubstr("m.csv")) << length;
  }
  EXPECT_EQ(csv_error(valid.substr(0, valid.size() - 1)), "no error");
}

RC_GTEST_PROP(CsvMatrix, ReadsBackWhatIsWritten, ()) {
  const TemporaryFolder folder;
  LabelledDistances written;
  written.distances = *square_matrices() / 3;
  const auto id = rc::gen::nonEmpty(rc::gen::container<std::string>(rc::gen::element('1', 'T', ',', '"', ' ', '\t')));
  std::set<std::string> ids;
  while (static_cast<Eigen::Index>(ids.size()) < written.distances.rows()) ids.insert(*id + std::to_string(ids.size()));
  written.ids.assign(ids.begin(), ids.end());
  write_csv_matrix(folder.path() / "m.csv", written);
  const LabelledDistances result = read_csv_matrix(folder.path() / "m.csv");
  RC_ASSERT(result.distances == written.distances);
  RC_ASSERT(result.ids == written.ids);
}

TEST(PsbMatrix, IsLittleEndianFloat32RowByRow) {
  using namespace std::string_literals;
  const TemporaryFolder folder;
  const auto bytes = "\0\0\0\0"s + "\0\0\xC0\x3F"s + "\0\0\x10\xC0"s + "\0\0\x80\x7F"s;
  const DistanceMatrix matrix = read_psb_matrix(folder.file("m.matrix", bytes));
  DistanceMatrix expected(2, 2);
  expected << 0, 1.5, -2.25, std::numeric_limits<double>::infinity();
  EXPECT_EQ(matrix, expected);
}

TEST(PsbMatrix, AnotherSizeIsAnErrorThatKnowsFloat64) {
  const TemporaryFolder folder;
  const auto error_for = [&](std::size_t bytes) {
    return test::input_error_of([&] { read_psb_matrix(folder.file("m.matrix", std::string(bytes, '\0'))); });
  };
  EXPECT_THAT(error_for(8 * 9), AllOf(HasSubstr("m.matrix: 72 bytes"), HasSubstr("float64 (3 x 3)")));
  EXPECT_THAT(error_for(4 * 9 - 1), AllOf(HasSubstr("m.matrix: 35 bytes"), HasSubstr("truncated")));
  EXPECT_THAT(error_for(4 * 10), HasSubstr("square matrix"));
  EXPECT_THAT(error_for(3), HasSubstr("square matrix"));
  EXPECT_THAT(error_for(0), HasSubstr("empty"));
  EXPECT_THAT(test::input_error_of([&] { read_psb_matrix(folder.path() / "none.matrix"); }), HasSubstr("none.matrix"));
}

TEST(PsbMatrix, EverySizeOfFileReadsOrIsAnError) {
  const TemporaryFolder folder;
  for (std::size_t bytes = 1; bytes <= 400; ++bytes) {
    const auto path = folder.file("m.matrix", std::string(bytes, '\0'));
    std::size_t size = 1;
    while (4 * size * size < bytes) ++size;
    const std::string error = test::input_error_of([&] {
      EXPECT_EQ(read_psb_matrix(path),
                DistanceMatrix::Zero(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(size)));
    });
    EXPECT_EQ(error == "no error", 4 * size * size == bytes) << bytes;
  }
}

RC_GTEST_PROP(PsbMatrix, ReadsBackWhatIsWritten, ()) {
  const TemporaryFolder folder;
  const DistanceMatrix matrix = *square_matrices();
  write_psb_matrix(folder.path() / "m.matrix", matrix);
  RC_ASSERT(read_psb_matrix(folder.path() / "m.matrix") == matrix);
}

DistanceMatrix read_text(const std::string& text) {
  const TemporaryFolder folder;
  return read_text_matrix(folder.file("m.txt", text));
}

std::string text_error(const std::string& text) {
  return test::input_error_of([&] { read_text(text); });
}

TEST(TextMatrix, MayHaveSemicolonsOrCommasBetweenTheNumbers) {
  for (const char* const text : {"0;1.5\n-2.25;inf\n", "# distances\n0, 1.5\n-2.25, inf\n", "0\t1.5\n-2.25\tinf\n"}) {
    EXPECT_EQ(parse_text_matrix(text, "m.txt"), example()) << text;
  }
  const auto error = [](const char* text) { return test::input_error_of([&] { parse_text_matrix(text, "m.txt"); }); };
  EXPECT_THAT(error("0,,1\n1,0,1\n1,1,0\n"), HasSubstr("m.txt:1: \"\" is not a number")) << "none is passed over";
  EXPECT_THAT(error("0;1,5\n1,5;0\n"), AllOf(HasSubstr("m.txt:1: \"1,5\""), HasSubstr("decimal points")));
}

TEST(TextMatrix, OneRowALineBetweenAnyBlanks) {
  DistanceMatrix expected(2, 2);
  expected << 0, 1.5, -2.25, std::numeric_limits<double>::infinity();
  EXPECT_EQ(read_text("0 1.5\n-2.25 inf\n"), expected);
  EXPECT_EQ(read_text("\xEF\xBB\xBF# distances\r\n\r\n\t0.0  1.50 \r\n  # more\r\n-225e-2\tInf"), expected);
}

TEST(TextMatrix, OneNumberIsAMatrix) { EXPECT_EQ(read_text("0"), DistanceMatrix::Zero(1, 1)); }

TEST(TextMatrix, AFaultIsOneErrorWithItsLine) {
  EXPECT_THAT(text_error("0 1\n1 x\n"), HasSubstr("m.txt:2: \"x\" is not a number (number 2 of the row)"));
  EXPECT_THAT(text_error("0 1\n\n1\n"), HasSubstr("m.txt:3: expected 2 numbers as in line 1, found 1"));
  EXPECT_THAT(text_error("0 1\n1 0 2\n"), HasSubstr("m.txt:2: expected 2 numbers as in line 1, found 3"));
  EXPECT_THAT(text_error("0 1\n1 0\n2 3\n"), HasSubstr("m.txt:3: expected a square distance matrix, found row 3"));
  EXPECT_THAT(text_error("0 1 2\n1 0 2\n"), HasSubstr("m.txt: expected a square distance matrix, found 2 rows of 3"));
  EXPECT_THAT(text_error("# nothing\n"), HasSubstr("m.txt: the file has no numbers"));
  EXPECT_THAT(text_error(""), HasSubstr("empty"));
}

TEST(TextMatrix, EveryPrefixReadsOrIsAnInputError) {
  const std::string valid = "# three models\n0 1.25 2e-1\n1.25 0 3\n2e-1 3 0\n";
  const std::size_t first_number = valid.find('0');
  for (std::size_t length = 0; length < valid.size(); ++length) {
    // A single number is a matrix; the final newline is optional.
    const bool alone = length == first_number + 1 || length == first_number + 2;
    const bool whole = length + 1 == valid.size();
    EXPECT_THAT(text_error(valid.substr(0, length)), HasSubstr(alone || whole ? "no error" : "m.txt")) << length;
  }
}

TEST(ReadDistanceMatrix, GoesByTheExtension) {
  const TemporaryFolder folder;
  write_npy(folder.path() / "m.npy", example());
  write_psb_matrix(folder.path() / "m.MATRIX", example());
  write_csv_matrix(folder.path() / "m.Csv", {example(), {"a", "b"}});
  const std::string text = "0 1.5\n-2.25 inf\n";
  for (const auto& path :
       {folder.path() / "m.npy", folder.path() / "m.MATRIX", folder.file("m.txt", text), folder.file("m.dat", text)}) {
    const LabelledDistances result = read_distance_matrix(path);
    EXPECT_EQ(result.distances, example()) << path;
    EXPECT_THAT(result.ids, IsEmpty()) << path;
  }
  EXPECT_EQ(read_distance_matrix(folder.path() / "m.Csv").distances, example());
  EXPECT_THAT(read_distance_matrix(folder.path() / "m.Csv").ids, ElementsAre("a", "b"));
}

TEST(ReadDistanceMatrix, AnotherExtensionIsAnErrorThatSaysWhatIsKnown) {
  for (const char* const name : {"m.xyz", "m", "npy"}) {
    EXPECT_THAT(test::input_error_of([&] { read_distance_matrix(name); }),
                AllOf(HasSubstr(name), HasSubstr(".matrix, .npy, .npz, .mat, .csv, .tsv, .txt, .dat")));
  }
}

TEST(ReadDistanceMatrix, NanIsAnErrorInEveryFormat) {
  const TemporaryFolder folder;
  DistanceMatrix matrix = DistanceMatrix::Zero(3, 3);
  matrix(2, 1) = std::numeric_limits<double>::quiet_NaN();
  write_npy(folder.path() / "m.npy", matrix);
  write_psb_matrix(folder.path() / "m.matrix", matrix);
  write_csv_matrix(folder.path() / "m.csv", {matrix, {}});
  for (const auto& path : {folder.path() / "m.npy", folder.path() / "m.matrix", folder.path() / "m.csv",
                           folder.file("m.txt", "0 0 0\n0 0 0\n0 NaN 0\n")}) {
    EXPECT_THAT(test::input_error_of([&] { read_distance_matrix(path); }),
                AllOf(HasSubstr(path.string()), HasSubstr("row 2, column 1")));
  }
}

TEST(ReadDistanceMatrix, AMissingFileOrAFolderIsAnInputError) {
  const TemporaryFolder folder;
  EXPECT_THAT(test::input_error_of([&] { read_distance_matrix(folder.path() / "none.npy"); }), HasSubstr("none.npy"));
  std::filesystem::create_directory(folder.path() / "folder.npy");
  EXPECT_THAT(test::input_error_of([&] { read_distance_matrix(folder.path() / "folder.npy"); }), HasSubstr("folder"));
}

RC_GTEST_PROP(OpenMatrix, BlocksAreThoseOfTheWholeMatrix, ()) {
  const TemporaryFolder folder;
  const DistanceMatrix matrix = *square_matrices();
  write_npy(folder.path() / "m.npy", matrix);
  write_psb_matrix(folder.path() / "m.matrix", matrix);
  write_csv_matrix(folder.path() / "m.csv", {matrix, {}});
  const auto size = matrix.rows();
  const auto row = *rc::gen::inRange<Eigen::Index>(0, size);
  const auto column = *rc::gen::inRange<Eigen::Index>(0, size);
  const auto rows = *rc::gen::inRange<Eigen::Index>(0, size - row + 1);
  const auto columns = *rc::gen::inRange<Eigen::Index>(0, size - column + 1);
  for (const char* name : {"m.npy", "m.matrix", "m.csv"}) {
    const OpenMatrix opened = open_matrix(folder.path() / name, TableShape::square);
    RC_ASSERT(opened.rows == size && opened.columns == size);
    const DistanceMatrix block =
        opened.read({.first_row = row, .rows = rows, .first_column = column, .columns = columns});
    RC_ASSERT(block == matrix.block(row, column, rows, columns));
    RC_ASSERT(whole_matrix(opened) == matrix);
  }
}

TEST(OpenMatrix, RefusesNanInTheBlockThatHasIt) {
  const TemporaryFolder folder;
  DistanceMatrix matrix = DistanceMatrix::Zero(5, 5);
  matrix(3, 1) = std::numeric_limits<double>::quiet_NaN();
  write_npy(folder.path() / "m.npy", matrix);
  const OpenMatrix opened = open_matrix(folder.path() / "m.npy", TableShape::square);
  EXPECT_EQ(opened.read({.first_row = 0, .rows = 3, .first_column = 0, .columns = 5}).rows(), 3);
  EXPECT_THAT(test::input_error_of([&] { opened.read({.first_row = 2, .rows = 3, .first_column = 1, .columns = 2}); }),
              AllOf(HasSubstr("m.npy"), HasSubstr("row 3, column 1")));
}

TEST(OpenMatrix, RefusesFilesOfAnotherSizeAndFilesThatShrink) {
  const TemporaryFolder folder;
  write_npy(folder.path() / "m.npy", DistanceMatrix::Ones(40, 40));
  const OpenMatrix opened = open_matrix(folder.path() / "m.npy", TableShape::square);
  std::filesystem::resize_file(folder.path() / "m.npy", 5000);
  EXPECT_THAT(test::input_error_of([&] { whole_matrix(opened); }), HasSubstr("truncated"));
  EXPECT_THAT(test::input_error_of([&] { open_matrix(folder.path() / "m.npy", TableShape::square); }),
              HasSubstr("truncated or damaged"));
  write_npy(folder.path() / "n.npy", DistanceMatrix::Ones(2, 3));
  EXPECT_EQ(open_matrix(folder.path() / "n.npy", TableShape::any).columns, 3);
  EXPECT_THAT(test::input_error_of([&] { open_matrix(folder.path() / "n.npy", TableShape::square); }),
              HasSubstr("square"));
}

}  // namespace

}  // namespace shapegauge
