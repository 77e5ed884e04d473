// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <string>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <utility>

#include "shapegauge/core/base/little_endian.h"
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

RC_GTEST_PROP(OpenMatrix, BlocksMatchTheWholeMatrix, ()) {
  const TemporaryFolder folder;
  const DistanceMatrix matrix = *square_matrices();
  write_npy(folder.path() / "m.npy", matrix);
  write_psb_matrix(folder.path() / "m.matrix", matrix);
  write_csv_matrix(folder.path() / "m.csv", matrix);
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

using OpenMatrixTest = test::FolderTest;

TEST_F(OpenMatrixTest, RejectsNanInTheRequestedBlock) {
  DistanceMatrix matrix = DistanceMatrix::Zero(5, 5);
  matrix(3, 1) = std::numeric_limits<double>::quiet_NaN();
  write_npy(at("m.npy"), matrix);
  const OpenMatrix opened = open_matrix(at("m.npy"), TableShape::square);
  EXPECT_EQ(opened.read({.first_row = 0, .rows = 3, .first_column = 0, .columns = 5}).rows(), 3);
  EXPECT_THAT(test::input_error_of([&] { opened.read({.first_row = 2, .rows = 3, .first_column = 1, .columns = 2}); }),
              AllOf(HasSubstr("m.npy"), HasSubstr("row 3, column 1")));
}

TEST_F(OpenMatrixTest, TreatsNanOnTheDiagonalAsMissingInEveryBlock) {
  DistanceMatrix matrix = DistanceMatrix::Ones(5, 5);
  matrix.diagonal().setConstant(std::numeric_limits<double>::quiet_NaN());
  write_npy(at("m.npy"), matrix);
  const OpenMatrix opened = open_matrix(at("m.npy"), TableShape::square);
  EXPECT_EQ(opened.read({.first_row = 2, .rows = 2, .first_column = 1, .columns = 2}),
            (DistanceMatrix{{1, 0}, {1, 1}}));
}

TEST_F(OpenMatrixTest, RejectsNonSquareFilesAndFilesTruncatedAfterOpening) {
  write_npy(at("m.npy"), DistanceMatrix::Ones(40, 40));
  const OpenMatrix opened = open_matrix(at("m.npy"), TableShape::square);
  std::filesystem::resize_file(at("m.npy"), 5000);
  EXPECT_THAT(test::input_error_of([&] { whole_matrix(opened); }), HasSubstr("truncated"));
  EXPECT_THAT(test::input_error_of([&] { open_matrix(at("m.npy"), TableShape::square); }),
              HasSubstr("truncated or damaged"));
  write_npy(at("n.npy"), DistanceMatrix::Ones(2, 3));
  EXPECT_EQ(open_matrix(at("n.npy"), TableShape::any).columns, 3);
  EXPECT_THAT(test::input_error_of([&] { open_matrix(at("n.npy"), TableShape::square); }), HasSubstr("square"));
}

/// Entry (i, j) is 1000 i + j.
DistanceMatrix numbered_matrix(Eigen::Index rows, Eigen::Index columns) {
  DistanceMatrix matrix(rows, columns);
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index j = 0; j < columns; ++j) matrix(i, j) = static_cast<double>(1000 * i + j);
  }
  return matrix;
}

TEST_F(OpenMatrixTest, ReadsBlocksOfTablesOfAnyShapeAndNumberType) {
  const DistanceMatrix matrix = numbered_matrix(5, 3);
  write_npy(at("c.npy"), matrix);
  // The same as float32 and as int16 column by column, as NumPy writes them.
  const auto npy = [&](const char* name, const std::string& type, const char* order, const std::string& data) {
    std::string header = "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': (5, 3), }";
    header.resize(117, ' ');
    header += '\n';
    static_cast<void>(folder_.file(name, std::string("\x93NUMPY\x01\x00\x76\x00", 10) + header + data));
  };
  std::string floats;
  std::string integers;
  for (Eigen::Index i = 0; i < 5; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) append_little_endian(floats, static_cast<float>(matrix(i, j)));
  }
  for (Eigen::Index j = 0; j < 3; ++j) {
    for (Eigen::Index i = 0; i < 5; ++i) append_little_endian(integers, static_cast<std::int16_t>(matrix(i, j)));
  }
  npy("f.npy", "<f4", "False", floats);
  npy("i.npy", "<i2", "True", integers);
  for (const char* name : {"c.npy", "f.npy", "i.npy"}) {
    const OpenMatrix opened = open_matrix(folder_.path() / name, TableShape::any);
    EXPECT_EQ(opened.rows, 5) << name;
    EXPECT_EQ(opened.columns, 3) << name;
    EXPECT_EQ(whole_matrix(opened), matrix) << name;
    const DistanceMatrix block = opened.read({.first_row = 2, .rows = 3, .first_column = 1, .columns = 2});
    EXPECT_EQ(block, (Eigen::Matrix<double, 3, 2>{{2001, 2002}, {3001, 3002}, {4001, 4002}})) << name;
  }
}

TEST_F(OpenMatrixTest, HasTheRowAndColumnIdsOfACsvTable) {
  const OpenMatrix table = open_matrix(folder_.file("t.csv", "id,x,y,z\na,0,1,2\nb,3,4,5\n"), TableShape::any);
  EXPECT_THAT(table.row_ids, ElementsAre("a", "b"));
  EXPECT_THAT(table.column_ids, ElementsAre("x", "y", "z"));
  const OpenMatrix square = open_matrix(folder_.file("s.csv", "id,a,b\na,0,1\nb,1,0\n"), TableShape::square);
  EXPECT_THAT(square.row_ids, ElementsAre("a", "b"));
  EXPECT_THAT(square.column_ids, ElementsAre("a", "b"));
}

TEST_F(OpenMatrixTest, KeepsTheNumbersAfterTheSourceTableIsDestroyed) {
  OpenMatrix opened;
  {
    LabelledTable table{.numbers = numbered_matrix(4, 6), .row_ids = {"a", "b", "c", "d"}, .column_ids = {}};
    opened = open_matrix(std::move(table));
  }
  EXPECT_EQ(opened.rows, 4);
  EXPECT_EQ(opened.columns, 6);
  EXPECT_EQ(opened.row_ids.size(), 4U);
  EXPECT_EQ(opened.read({.first_row = 1, .rows = 1, .first_column = 5, .columns = 1})(0, 0), 1005);
  EXPECT_EQ(whole_matrix(opened), numbered_matrix(4, 6));
}

TEST_F(OpenMatrixTest, BlocksAreTheSameOnAnyNumberOfThreads) {
  const DistanceMatrix matrix = numbered_matrix(300, 40);
  write_npy(at("m.npy"), matrix);
  const OpenMatrix opened = open_matrix(at("m.npy"), TableShape::any);
  const tbb::global_control more_threads_than_cores(tbb::global_control::max_allowed_parallelism, 8);
  for (const int threads : {1, 5}) {
    EXPECT_EQ(tbb::task_arena(threads).execute([&] { return whole_matrix(opened); }), matrix) << threads;
  }
}

}  // namespace

}  // namespace shapegauge
