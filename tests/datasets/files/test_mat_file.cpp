// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <matio.h>

#include "shapegauge/datasets/files/mat_file.h"
#include "shapegauge/datasets/files/matrix_files.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using testing::AllOf;
using testing::HasSubstr;

// Builds a MATLAB version 5 file from variables.
class MatFile {
 public:
  explicit MatFile(const std::filesystem::path& path) : file_(Mat_CreateVer(path.c_str(), nullptr, MAT_FT_MAT5)) {}
  MatFile(const MatFile&) = delete;
  MatFile& operator=(const MatFile&) = delete;
  ~MatFile() { Mat_Close(file_); }

  // Two rows of three numbers, in column-major order, or the first numbers in another size.
  template <typename Number>
  void add(const char* name, matio_classes numbers, matio_types type, std::array<Number, 6> columns,
           matio_compression compression = MAT_COMPRESSION_ZLIB, std::array<std::size_t, 2> size = {2, 3}) {
    matvar_t* const variable = Mat_VarCreate(name, numbers, type, 2, size.data(), columns.data(), 0);
    Mat_VarWrite(file_, variable, compression);
    Mat_VarFree(variable);
  }

 private:
  mat_t* file_;
};

using MatFileTest = test::FolderTest;

TEST_F(MatFileTest, ReadsTheSingleMatrixInColumnMajorOrder) {
  const DistanceMatrix expected{{1, 3, 5}, {2, 4, 6}};
  MatFile(at("a.mat")).add<double>("D", MAT_C_DOUBLE, MAT_T_DOUBLE, {1, 2, 3, 4, 5, 6});
  MatFile(at("b.mat")).add<float>("D", MAT_C_SINGLE, MAT_T_SINGLE, {1, 2, 3, 4, 5, 6});
  MatFile(at("c.mat")).add<mat_uint8_t>("D", MAT_C_UINT8, MAT_T_UINT8, {1, 2, 3, 4, 5, 6});
  for (const char* name : {"a.mat", "b.mat", "c.mat"}) {
    EXPECT_EQ(read_mat(folder_.path() / name), expected) << name;
    EXPECT_EQ(read_matrix(folder_.path() / name, TableShape::any).numbers, expected) << name;
  }
  EXPECT_THAT(test::input_error_of([&] { read_matrix(at("a.mat"), TableShape::square); }),
              AllOf(HasSubstr("a.mat"), HasSubstr("square"), HasSubstr("2 x 3")));
}

TEST_F(MatFileTest, ReadsASingleNumberAsAMatrix) {
  MatFile(at("a.mat")).add<double>("D", MAT_C_DOUBLE, MAT_T_DOUBLE, {7}, MAT_COMPRESSION_ZLIB, {1, 1});
  EXPECT_EQ(read_mat(at("a.mat")), DistanceMatrix::Constant(1, 1, 7));
}

TEST_F(MatFileTest, RejectsAMatrixThatUnpacksBeyondTheSizeLimit) {
  MatFile(at("a.mat")).add<double>("D", MAT_C_DOUBLE, MAT_T_DOUBLE, {1, 2, 3, 4, 5, 6}, MAT_COMPRESSION_NONE);
  std::string bytes = test::bytes_of(at("a.mat"));
  const std::string size("\x02\0\0\0\x03\0\0\0", 8);
  ASSERT_NE(bytes.find(size), std::string::npos);
  bytes.replace(bytes.find(size), size.size(), std::string("\0\0\x01\0\0\0\x01\0", 8));
  EXPECT_THAT(test::input_error_of([&] { read_mat(folder_.file("large.mat", bytes)); }),
              AllOf(HasSubstr("large.mat"), HasSubstr("256 MiB")));
}

TEST_F(MatFileTest, RejectsFilesThatAreNotMatFiles) {
  {
    MatFile two(at("two.mat"));
    two.add<double>("D", MAT_C_DOUBLE, MAT_T_DOUBLE, {1, 2, 3, 4, 5, 6});
    two.add<double>("E", MAT_C_DOUBLE, MAT_T_DOUBLE, {1, 2, 3, 4, 5, 6});
  }
  EXPECT_THAT(test::input_error_of([&] { read_mat(at("two.mat")); }), HasSubstr("several matrices: D, E"));
  EXPECT_EQ(read_mat(at("two.mat"), "E")(0, 0), 1);
  EXPECT_THAT(test::input_error_of([&] { read_mat(at("two.mat"), "F"); }), HasSubstr("no matrix \"F\""));
  EXPECT_THAT(test::input_error_of([&] { read_mat(folder_.file("x.mat", "no such file")); }), HasSubstr("x.mat"));
  EXPECT_THAT(test::input_error_of([&] { read_mat(at("none.mat")); }), HasSubstr("none.mat"));
}

}  // namespace

}  // namespace shapegauge
