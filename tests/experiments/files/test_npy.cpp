#include <array>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <string>

#include "shapegauge/experiments/files/npy.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/experiments/files/random_matrices.h"
#include "tests/experiments/input_error.h"

namespace shapegauge {

namespace {

using namespace std::string_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::string version_1(const std::string& dictionary) {
  return "\x93NUMPY\x01\x00"s + static_cast<char>(dictionary.size()) + '\0' + dictionary;
}

std::string error_of(const std::string& bytes) {
  return input_error_of([&] { parse_npy_header(bytes, "x.npy"); });
}

TEST(NpyHeader, IsAPythonDictionaryInAnyOrderAndSpacing) {
  const std::string dictionary = "{ \"shape\":(2 ,3L),'fortran_order' :True,\n'descr':'>f4'}  \n";
  const NpyHeader header = parse_npy_header(version_1(dictionary), "x");
  EXPECT_EQ(header.type, ">f4");
  EXPECT_TRUE(header.column_by_column);
  EXPECT_THAT(header.shape, ElementsAre(2, 3));
  EXPECT_EQ(header.data_begin, 10 + dictionary.size());
}

TEST(NpyHeader, TakesShapesOfAnyDimension) {
  const auto shape_of = [](const std::string& shape) {
    return parse_npy_header(version_1("{'descr': '<f8', 'fortran_order': False, 'shape': " + shape + ", }"), "x").shape;
  };
  EXPECT_THAT(shape_of("()"), ElementsAre());
  EXPECT_THAT(shape_of("(5,)"), ElementsAre(5));
  EXPECT_THAT(shape_of("(1, 2, 3)"), ElementsAre(1, 2, 3));
}

TEST(NpyHeader, AFaultIsOneErrorWithItsByte) {
  EXPECT_THAT(error_of("\x89PNG"), StartsWith("x.npy: this is no .npy file"));
  EXPECT_THAT(error_of("\x93NUMP"), StartsWith("x.npy: this is no .npy file"));
  EXPECT_THAT(error_of("\x93NUMPY\x04\x00\x00\x00\x00\x00"s), StartsWith("x.npy: version 4.0"));
  EXPECT_THAT(error_of("\x93NUMPY\x00\x00\x00\x00"s), StartsWith("x.npy: version 0.0"));
  EXPECT_THAT(error_of("\x93NUMPY\x02\x00\xFF\xFF\xFF\xFF{"s), HasSubstr("within its header"));
  const std::array dictionaries = {
      std::array{"", "x.npy: byte 10: expected {"},
      std::array{"[1]", "x.npy: byte 10: expected {"},
      std::array{"{'descr': '<f8'", "x.npy: byte 25: expected , or }"},
      std::array{"{'descr': [('a', '<f8')]}", "x.npy: byte 20: the file holds records"},
      std::array{"{'descr': '<f8}", "x.npy: byte 20: a string in the header does not end"},
      std::array{"{descr: '<f8'}", "x.npy: byte 11: expected a string"},
      std::array{"{'order': 'C'}", "x.npy: byte 19: the header has an unknown key \"order\""},
      std::array{"{'fortran_order': 1}", "x.npy: byte 28: expected True or False"},
      std::array{"{'shape': 3}", "x.npy: byte 20: expected ("},
      std::array{"{'shape': (-3, 3)}", "x.npy: byte 21: expected a whole number"},
      std::array{"{'shape': (99999999999999999999, 3)}", "x.npy: byte 21: expected a whole number"},
      std::array{"{'shape': (3 3)}", "x.npy: byte 23: expected , or )"},
      std::array{"{'shape': (3, 3)}", "x.npy: byte 27: the header must have the keys"},
      std::array{"{} x", "x.npy: byte 13: something follows"},
  };
  for (const auto& [dictionary, error] : dictionaries) EXPECT_THAT(error_of(version_1(dictionary)), StartsWith(error));
}

TEST(NpyHeader, WrittenHeadersAlignTheDataAndReadBack) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{600}, std::size_t{12345678901234}}) {
    const std::string bytes = npy_header_of_matrix(size, size + 1);
    EXPECT_EQ(bytes.size() % 64, 0U);
    const NpyHeader header = parse_npy_header(bytes, "x");
    EXPECT_EQ(header.data_begin, bytes.size());
    EXPECT_EQ(header.type, "<f8");
    EXPECT_FALSE(header.column_by_column);
    EXPECT_THAT(header.shape, ElementsAre(size, size + 1));
  }
}

}  // namespace

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
