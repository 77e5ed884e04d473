#include <array>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <string>

#include "shapegauge/experiments/matrices/npy.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/experiments/input_error.h"
#include "tests/experiments/matrices/random_matrices.h"

namespace shapegauge {
namespace {

using namespace std::string_literals;
using test_io::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

// [[0, 1.5], [-2.25, inf]] as NumPy 1.24 writes it (numpy.lib.format.write_array).
const std::string float64_version_1 =
    "\x93NUMPY\x01\x00v\x00{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2), }"s + std::string(58, ' ') +
    "\n\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\xf8?\x00\x00\x00\x00\x00\x00\x02\xc0"s +
    "\x00\x00\x00\x00\x00\x00\xf0\x7f"s;
const std::string float32_fortran_version_2 =
    "\x93NUMPY\x02\x00t\x00\x00\x00{'descr': '<f4', 'fortran_order': True, 'shape': (2, 2), }"s + std::string(57, ' ') +
    "\n\x00\x00\x00\x00\x00\x00\x10\xc0\x00\x00\xc0?\x00\x00\x80\x7f"s;
const std::string float64_big_endian_version_3 =
    "\x93NUMPY\x03\x00t\x00\x00\x00{'descr': '>f8', 'fortran_order': False, 'shape': (2, 2), }"s +
    std::string(56, ' ') +
    "\n\x00\x00\x00\x00\x00\x00\x00\x00?\xf8\x00\x00\x00\x00\x00\x00\xc0\x02\x00\x00\x00\x00\x00\x00"s +
    "\x7f\xf0\x00\x00\x00\x00\x00\x00"s;
const std::string float32_big_endian_fortran_version_1 =
    "\x93NUMPY\x01\x00v\x00{'descr': '>f4', 'fortran_order': True, 'shape': (2, 2), }"s + std::string(59, ' ') +
    "\n\x00\x00\x00\x00\xc0\x10\x00\x00?\xc0\x00\x00\x7f\x80\x00\x00"s;

DistanceMatrix example() {
  DistanceMatrix matrix(2, 2);
  matrix << 0, 1.5, -2.25, std::numeric_limits<double>::infinity();
  return matrix;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

std::string error_of(const std::string& bytes) {
  const TemporaryFolder folder;
  return input_error_of([&] { read_npy(folder.file("x.npy", bytes)); });
}

TEST(Npy, ReadsWhatNumpyWrites) {
  const TemporaryFolder folder;
  for (const std::string& bytes : {float64_version_1, float32_fortran_version_2, float64_big_endian_version_3,
                                   float32_big_endian_fortran_version_1}) {
    EXPECT_EQ(read_npy(folder.file("x.npy", bytes)), example());
  }
}

TEST(Npy, WritesWhatNumpyWrites) {
  const TemporaryFolder folder;
  write_npy(folder.path() / "x.npy", example());
  EXPECT_EQ(test_io::bytes_of(folder.path() / "x.npy"), float64_version_1);
}

TEST(Npy, WritesVectorsAsNumpyDoes) {
  const TemporaryFolder folder;
  write_npy_vector(folder.path() / "v.npy", Eigen::Vector2d(0, 1.5));
  EXPECT_EQ(test_io::bytes_of(folder.path() / "v.npy"),
            "\x93NUMPY\x01\x00v\x00{'descr': '<f8', 'fortran_order': False, 'shape': (2,), }"s + std::string(60, ' ') +
                "\n\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\xf8?"s);
}

TEST(Npy, OtherTypesAndShapesAreErrors) {
  for (const char* const type : {"<i8", "|b1", "<c8", "<f2", "=f8", "|O8", "<U3"}) {
    EXPECT_THAT(error_of(replaced(float64_version_1, "<f8", type)),
                AllOf(HasSubstr("x.npy: numbers of type \""s + type), HasSubstr("float32 or float64")));
  }
  for (const char* const shape : {"(4, 1)", "(1, 4)", "(4,)  ", "(    )", "(0, 0)"}) {
    EXPECT_THAT(error_of(replaced(float64_version_1, "(2, 2)", shape)), HasSubstr("a distance matrix is square"));
  }
}

TEST(Npy, DataOfAnotherLengthIsAnError) {
  EXPECT_THAT(error_of(float64_version_1 + "x"), HasSubstr("33 bytes of data"));
  EXPECT_THAT(error_of(replaced(float64_version_1, "(2, 2)", "(3, 3)")), HasSubstr("shape (3, 3) and type <f8"));
  EXPECT_THAT(error_of(replaced(float64_version_1, "<f8", "<f4")), HasSubstr("32 bytes of data"));
  // 2^32 squared is 0 in 64 bits, and 2^64 - 1 the largest number of all.
  EXPECT_THAT(
      error_of(replaced(float64_version_1, "(2, 2), }" + std::string(22, ' '), "(4294967296, 4294967296), }    ")),
      HasSubstr("is not what an array of shape"));
  EXPECT_THAT(error_of(replaced(float64_version_1, "(2, 2), }" + std::string(40, ' '),
                                "(18446744073709551615, 18446744073709551615), }  ")),
              HasSubstr("is not what an array of shape"));
}

TEST(Npy, EveryPrefixIsAnInputError) {
  const TemporaryFolder folder;
  for (const std::string& bytes : {float64_version_1, float32_fortran_version_2}) {
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      const auto path = folder.file("x.npy", bytes.substr(0, length));
      EXPECT_THAT(input_error_of([&] { read_npy(path); }), HasSubstr("x.npy")) << length;
    }
  }
}

RC_GTEST_PROP(Npy, DamagedFilesReadOrAreInputErrors, ()) {
  const TemporaryFolder folder;
  std::string bytes = *rc::gen::element(float64_version_1, float32_fortran_version_2);
  const auto changes = *rc::gen::inRange(1, 5);
  for (int i = 0; i < changes; ++i) {
    bytes[*rc::gen::inRange<std::size_t>(0, bytes.size())] = *rc::gen::oneOf(
        rc::gen::arbitrary<char>(), rc::gen::element('9', '(', ')', ',', '\'', '{', '}', ' ', 'L', '\xFF'));
  }
  const std::string error = input_error_of([&] { read_npy(folder.file("x.npy", bytes)); });
  RC_ASSERT(error == "no error" || error.find("x.npy") != std::string::npos);
}

RC_GTEST_PROP(Npy, ReadsBackWhatIsWritten, ()) {
  const TemporaryFolder folder;
  // A third of a float32 needs all of the float64.
  const DistanceMatrix matrix = *square_matrices() / 3;
  write_npy(folder.path() / "m.npy", matrix);
  RC_ASSERT(read_npy(folder.path() / "m.npy") == matrix);
}

}  // namespace
}  // namespace shapegauge
