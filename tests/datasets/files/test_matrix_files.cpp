// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/datasets/files/matrix_files.h"
#include "shapegauge/datasets/files/npy.h"
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

DistanceMatrix example() { return DistanceMatrix{{0, 1.5}, {-2.25, std::numeric_limits<double>::infinity()}}; }

TEST(CsvTable, MayHaveNumericIdsAndAnEmptyFirstHeaderCell) {
  const test::TemporaryFolder folder;
  for (const char* corner : {"", "id"}) {
    test::write_text(folder.path() / "x.csv", std::string(corner) + ",1,2,3\n7,0,1,4\n5,2,0,6\n");
    const LabelledTable table = read_matrix(folder.path() / "x.csv", TableShape::any);
    EXPECT_THAT(table.row_ids, ElementsAre("7", "5")) << corner;
    EXPECT_THAT(table.column_ids, ElementsAre("1", "2", "3")) << corner;
    EXPECT_EQ(table.numbers, (Eigen::Matrix<double, 2, 3>{{0, 1, 4}, {2, 0, 6}})) << corner;
  }
  test::write_text(folder.path() / "x.csv", "4,1,2\n7,0,1\n");
  EXPECT_EQ(read_matrix(folder.path() / "x.csv", TableShape::any).numbers.rows(), 2) << "no corner, no ids";
}

TEST(CsvMatrix, ReadsTsvFiles) {
  const test::TemporaryFolder folder;
  test::write_text(folder.path() / "m.tsv", "\tT1\tT2\nT1\t0\t1.5\nT2\t-2.25\tinf\n");
  EXPECT_EQ(read_matrix(folder.path() / "m.tsv", TableShape::square).numbers, example());
}

using PsbMatrixTest = test::FolderTest;

TEST_F(PsbMatrixTest, ReadsLittleEndianFloat32InRowMajorOrder) {
  using namespace std::string_literals;
  const auto bytes = "\0\0\0\0"s + "\0\0\xC0\x3F"s + "\0\0\x10\xC0"s + "\0\0\x80\x7F"s;
  const DistanceMatrix matrix = read_matrix(folder_.file("m.matrix", bytes), TableShape::square).numbers;
  const DistanceMatrix expected{{0, 1.5}, {-2.25, std::numeric_limits<double>::infinity()}};
  EXPECT_EQ(matrix, expected);
}

TEST_F(PsbMatrixTest, RejectsFileSizesOfNonSquareMatricesAndSuggestsFloat64) {
  const auto error_for = [&](std::size_t bytes) {
    return test::input_error_of(
        [&] { read_matrix(folder_.file("m.matrix", std::string(bytes, '\0')), TableShape::square); });
  };
  EXPECT_THAT(error_for(8 * 9), AllOf(HasSubstr("m.matrix: 72 bytes"), HasSubstr("float64 (3 x 3)")));
  EXPECT_THAT(error_for(4 * 9 - 1), AllOf(HasSubstr("m.matrix: 35 bytes"), HasSubstr("truncated")));
  EXPECT_THAT(error_for(4 * 10), HasSubstr("square matrix"));
  EXPECT_THAT(error_for(3), HasSubstr("square matrix"));
  EXPECT_THAT(error_for(0), HasSubstr("empty"));
  EXPECT_THAT(test::input_error_of([&] { read_matrix(at("none.matrix"), TableShape::square); }),
              HasSubstr("none.matrix"));
}

TEST_F(PsbMatrixTest, AcceptsExactlyTheFileSizesOfSquareMatrices) {
  for (std::size_t bytes = 1; bytes <= 400; ++bytes) {
    const auto path = folder_.file("m.matrix", std::string(bytes, '\0'));
    std::size_t size = 1;
    while (4 * size * size < bytes) ++size;
    const std::string error = test::input_error_of([&] {
      EXPECT_EQ(read_matrix(path, TableShape::square).numbers,
                DistanceMatrix::Zero(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(size)));
    });
    EXPECT_EQ(error == "no error", 4 * size * size == bytes) << bytes;
  }
}

RC_GTEST_PROP(PsbMatrix, IsReadBackAsWritten, ()) {
  const TemporaryFolder folder;
  const DistanceMatrix matrix = *square_matrices();
  write_psb_matrix(folder.path() / "m.matrix", matrix);
  RC_ASSERT(read_matrix(folder.path() / "m.matrix", TableShape::square).numbers == matrix);
}

using ReadDistanceMatrix = test::FolderTest;

TEST_F(ReadDistanceMatrix, SelectsTheFormatByExtension) {
  write_npy(at("m.npy"), example());
  write_psb_matrix(at("m.MATRIX"), example());
  write_csv_matrix(at("m.Csv"), example(), {"a", "b"});
  const std::string text = "0 1.5\n-2.25 inf\n";
  for (const auto& path : {at("m.npy"), at("m.MATRIX"), folder_.file("m.txt", text), folder_.file("m.dat", text)}) {
    const LabelledTable result = read_matrix(path, TableShape::square);
    EXPECT_EQ(result.numbers, example()) << path;
    EXPECT_THAT(result.row_ids, IsEmpty()) << path;
  }
  EXPECT_EQ(read_matrix(at("m.Csv"), TableShape::square).numbers, example());
  EXPECT_THAT(read_matrix(at("m.Csv"), TableShape::square).row_ids, ElementsAre("a", "b"));
}

TEST_F(ReadDistanceMatrix, ListsTheKnownExtensionsForAnUnknownExtension) {
  for (const char* const name : {"m.xyz", "m", "npy"}) {
    EXPECT_THAT(test::input_error_of([&] { read_matrix(name, TableShape::square); }),
                AllOf(HasSubstr(name), HasSubstr(".matrix, .npy, .npz, .mat, .csv, .tsv, .txt, .dat")));
  }
}

TEST_F(ReadDistanceMatrix, RejectsNanInEveryFormat) {
  DistanceMatrix matrix = DistanceMatrix::Zero(3, 3);
  matrix(2, 1) = std::numeric_limits<double>::quiet_NaN();
  write_npy(at("m.npy"), matrix);
  write_psb_matrix(at("m.matrix"), matrix);
  write_csv_matrix(at("m.csv"), matrix);
  for (const auto& path :
       {at("m.npy"), at("m.matrix"), at("m.csv"), folder_.file("m.txt", "0 0 0\n0 0 0\n0 NaN 0\n")}) {
    EXPECT_THAT(test::input_error_of([&] { read_matrix(path, TableShape::square); }),
                AllOf(HasSubstr(path.string()), HasSubstr("row 2, column 1")));
  }
}

// Text as Excel saves it: UTF-16 with a byte order mark.
std::string utf16(std::string_view ascii, bool big_endian) {
  std::string text = big_endian ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : ascii) big_endian ? text.append({'\0', c}) : text.append({c, '\0'});
  return text;
}

TEST_F(ReadDistanceMatrix, AcceptsTextInUtf16) {
  for (const bool big_endian : {false, true}) {
    EXPECT_EQ(
        read_matrix(folder_.file("m.csv", utf16("0,1.5\r\n-2.25,inf\r\n", big_endian)), TableShape::square).numbers,
        example());
    EXPECT_EQ(read_matrix(folder_.file("m.txt", utf16("0\t1.5\n-2.25\tinf\n", big_endian)), TableShape::square).numbers,
              example());
  }
}

TEST_F(ReadDistanceMatrix, TreatsNanOnTheDiagonalAsMissing) {
  DistanceMatrix matrix{{1, 2.5}, {3, 4}};
  matrix.diagonal().setConstant(std::numeric_limits<double>::quiet_NaN());
  write_npy(at("m.npy"), matrix);
  const DistanceMatrix expected{{0, 2.5}, {3, 0}};
  for (const auto& path : {at("m.npy"), folder_.file("m.txt", "nan 2.5\n3 NA\n"), folder_.file("m.csv", "NA,2.5\n3,\n"),
                           folder_.file("n.csv", "id,a,b\na,,2.5\nb,3,nan\n")}) {
    EXPECT_EQ(read_matrix(path, TableShape::square).numbers, expected) << path;
  }
}

TEST_F(ReadDistanceMatrix, ReadsCondensedDistancesAsTheUpperTriangle) {
  const DistanceMatrix expected{{0, 1, 2, 3}, {1, 0, 4, 5}, {2, 4, 0, 6}, {3, 5, 6, 0}};
  const Eigen::VectorXd condensed = Eigen::VectorXd::LinSpaced(6, 1, 6);
  write_npy_vector(at("m.npy"), condensed);
  write_npy(at("row.npy"), DistanceMatrix(condensed.transpose()));
  for (const auto& path : {at("m.npy"), at("row.npy"), folder_.file("row.txt", "1 2 3 4 5 6\n"),
                           folder_.file("column.txt", "# pdist\n1\n2\n3\n4\n5\n6\n")}) {
    EXPECT_EQ(read_matrix(path, TableShape::square).numbers, expected) << path;
    EXPECT_EQ(read_matrix(path, TableShape::any).numbers.size(), 6) << path;
  }
  write_npy_vector(at("five.npy"), condensed.head(5));
  EXPECT_THAT(test::input_error_of([&] { read_matrix(at("five.npy"), TableShape::square); }), HasSubstr("square"));
}

TEST_F(ReadDistanceMatrix, RecognisesVectorsOfTriangularLengthAsCondensedDistances) {
  const auto is_condensed = [](const std::vector<std::uint64_t>& shape) { return is_condensed_shape(shape); };
  for (const std::vector<std::uint64_t>& shape : {std::vector<std::uint64_t>{1}, {6}, {1, 6}, {6, 1}, {4'498'500}}) {
    EXPECT_TRUE(is_condensed(shape)) << testing::PrintToString(shape);
  }
  for (const std::vector<std::uint64_t>& shape : {std::vector<std::uint64_t>{},
                                                  {0},
                                                  {5},
                                                  {1, 1},
                                                  {3, 2},
                                                  {1, 1, 6},
                                                  {std::numeric_limits<std::int64_t>::max()},
                                                  {std::numeric_limits<std::uint64_t>::max()}}) {
    EXPECT_FALSE(is_condensed(shape)) << testing::PrintToString(shape);
  }
}

TEST_F(ReadDistanceMatrix, RejectsIntegersThatWouldBeRounded) {
  for (const char* text : {"0 9007199254740993\n1 0\n", "0 -123456789012345678901\n1 0\n"}) {
    EXPECT_THAT(test::input_error_of([&] { read_matrix(folder_.file("m.txt", text), TableShape::square); }),
                AllOf(HasSubstr("m.txt:1"), HasSubstr("2^53")));
  }
  EXPECT_EQ(read_matrix(folder_.file("m.txt", "0 9007199254740992\n1e300 0\n"), TableShape::square).numbers(0, 1),
            9007199254740992.0);
}

TEST_F(ReadDistanceMatrix, RejectsAVariableNameForAPlainTextFile) {
  EXPECT_THAT(test::input_error_of([&] { read_matrix(folder_.file("m.txt", "0 1\n1 0\n"), TableShape::square, "D"); }),
              HasSubstr("`variable`"));
}

TEST_F(ReadDistanceMatrix, RejectsAMissingFileOrAFolder) {
  EXPECT_THAT(test::input_error_of([&] { read_matrix(at("none.npy"), TableShape::square); }), HasSubstr("none.npy"));
  std::filesystem::create_directory(at("folder.npy"));
  EXPECT_THAT(test::input_error_of([&] { read_matrix(at("folder.npy"), TableShape::square); }), HasSubstr("folder"));
}

}  // namespace

}  // namespace shapegauge
