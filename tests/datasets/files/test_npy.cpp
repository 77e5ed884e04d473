// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>
#include <string>

#include "shapegauge/datasets/files/npy.h"
#include "tests/datasets/files/random_matrices.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using namespace std::string_literals;
using test::TemporaryFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::string version_1(const std::string& dictionary) {
  return "\x93NUMPY\x01\x00"s + static_cast<char>(dictionary.size()) + '\0' + dictionary;
}

std::string header_error(const std::string& bytes) {
  return test::input_error_of([&] { parse_npy_header(bytes, "x.npy"); });
}

TEST(NpyHeader, AcceptsDictionaryKeysInAnyOrderAndSpacing) {
  const std::string dictionary = "{ \"shape\":(2 ,3L),'fortran_order' :True,\n'descr':'>f4'}  \n";
  const NpyHeader header = parse_npy_header(version_1(dictionary), "x");
  EXPECT_EQ(header.type, ">f4");
  EXPECT_TRUE(header.column_by_column);
  EXPECT_THAT(header.shape, ElementsAre(2, 3));
  EXPECT_EQ(header.data_begin, 10 + dictionary.size());
}

TEST(NpyHeader, AcceptsShapesOfAnyDimension) {
  const auto shape_of = [](const std::string& shape) {
    return parse_npy_header(version_1("{'descr': '<f8', 'fortran_order': False, 'shape': " + shape + ", }"), "x").shape;
  };
  EXPECT_THAT(shape_of("()"), ElementsAre());
  EXPECT_THAT(shape_of("(5,)"), ElementsAre(5));
  EXPECT_THAT(shape_of("(1, 2, 3)"), ElementsAre(1, 2, 3));
}

TEST(NpyHeader, RejectsSizesThatOverflow) {
  // 2^61 numbers of 8 bytes are 2^64 bytes, 0 as a 64-bit count.
  const std::string bytes = version_1("{'descr': '<f8', 'fortran_order': False, 'shape': (2305843009213693952, 1), }");
  EXPECT_THAT(test::input_error_of([&] { parse_npy_table_header(bytes, bytes.size(), TableShape::any, "x.npy"); }),
              StartsWith("x.npy: 0 bytes of data"));
}

TEST(NpyHeader, ErrorMessagesGiveTheBytePosition) {
  EXPECT_THAT(header_error("\x89PNG"), StartsWith("x.npy: this is no .npy file"));
  EXPECT_THAT(header_error("\x93NUMP"), StartsWith("x.npy: this is no .npy file"));
  EXPECT_THAT(header_error("\x93NUMPY\x04\x00\x00\x00\x00\x00"s), StartsWith("x.npy: version 4.0"));
  EXPECT_THAT(header_error("\x93NUMPY\x00\x00\x00\x00"s), StartsWith("x.npy: version 0.0"));
  EXPECT_THAT(header_error("\x93NUMPY\x02\x00\xFF\xFF\xFF\xFF{"s), HasSubstr("within its header"));
  EXPECT_THAT(header_error(version_1("{'descr': [('a', '<f8')]}")), StartsWith("x.npy: the file holds records"));
  const std::string rest = ", 'fortran_order': False, 'shape': (3, 3)}";
  for (const std::string& dictionary :
       {""s, "[1]"s, "{} x"s, "{'descr': '<f8'"s, "{'descr': '<f8}"s, "{descr: '<f8'" + rest, "{'descr': 8" + rest,
        "{'order': 'C'" + rest, "{'order': 'C', 'descr': '<f8'" + rest, "{'descr': '<f8'" + rest + " x",
        "{'descr': '<f8', 'fortran_order': 1, 'shape': (3, 3)}"s,
        "{'descr': '<f8', 'fortran_order': False, 'shape': 3}"s,
        "{'descr': '<f8', 'fortran_order': False, 'shape': (-3, 3)}"s,
        "{'descr': '<f8', 'fortran_order': False, 'shape': (99999999999999999999, 3)}"s,
        "{'descr': '<f8', 'fortran_order': False, 'shape': (3 3)}"s}) {
    EXPECT_THAT(header_error(version_1(dictionary)), StartsWith("x.npy: byte 10: the header must be a dictionary"))
        << dictionary;
  }
}

TEST(NpyHeader, AlignsTheDataTo64BytesAndIsReadBackUnchanged) {
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

DistanceMatrix npy_example() { return DistanceMatrix{{0, 1.5}, {-2.25, std::numeric_limits<double>::infinity()}}; }

std::string npy_replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

std::string npy_error_of(const std::string& bytes) {
  return test::input_error_of([&] { parse_npy(bytes, "x.npy", TableShape::square); });
}

using NpyTest = test::FolderTest;

TEST_F(NpyTest, ReadsFilesWrittenByNumpy) {
  for (const std::string& bytes : {float64_version_1, float32_fortran_version_2, float64_big_endian_version_3,
                                   float32_big_endian_fortran_version_1}) {
    EXPECT_EQ(parse_npy(bytes, "x.npy", TableShape::square), npy_example());
  }
}

// .npy file with one row, from the bytes of its numbers.
DistanceMatrix row_of(const std::string& type, const std::string& bytes, std::size_t count) {
  const std::string shape = "(1, " + std::to_string(count) + ")";
  return parse_npy(version_1("{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }") + bytes,
                   "x", TableShape::any);
}

TEST_F(NpyTest, ReadsIntegersAndBooleans) {
  EXPECT_EQ(row_of("|i1", "\x05\xFF\x80"s, 3), (DistanceMatrix{{5, -1, -128}}));
  EXPECT_EQ(row_of("|u1", "\x05\xFF"s, 2), (DistanceMatrix{{5, 255}}));
  EXPECT_EQ(row_of("|b1", "\x00\x01"s, 2), (DistanceMatrix{{0, 1}}));
  EXPECT_EQ(row_of("<i2", "\x01\x02\xFE\xFF"s, 2), (DistanceMatrix{{513, -2}}));
  EXPECT_EQ(row_of(">i2", "\x01\x02\xFE\xFF"s, 2), (DistanceMatrix{{258, -257}}));
  EXPECT_EQ(row_of("<u4", "\xFF\xFF\xFF\xFF"s, 1), (DistanceMatrix{{4294967295.0}}));
  EXPECT_EQ(row_of("<i8", "\xFD\xFF\xFF\xFF\xFF\xFF\xFF\xFF"s, 1), (DistanceMatrix{{-3}}));
  EXPECT_EQ(row_of("=i4", "\x07\x00\x00\x00"s, 1), (DistanceMatrix{{7}}));
  EXPECT_EQ(row_of("<u8", "\x00\x00\x00\x00\x00\x00\x20\x00"s, 1), (DistanceMatrix{{9007199254740992.0}}));
  for (const char* type : {"<i8", "<u8"}) {
    EXPECT_THAT(test::input_error_of([&] { row_of(type, "\x01\x00\x00\x00\x00\x00\x20\x00"s, 1); }),
                HasSubstr("9007199254740993 is beyond 2^53"))
        << type;
  }
  EXPECT_THAT(test::input_error_of([&] { row_of("<i8", "\xFF\xFF\xFF\xFF\xFF\xFF\xDF\xFF"s, 1); }),
              HasSubstr("-9007199254740993"));
}

// Values of IEEE 754 binary16: 1, -2, 65504 (the largest), 2^-24 (the smallest), 1/3 rounded, infinity.
TEST_F(NpyTest, ReadsFloat16) {
  const DistanceMatrix expected{
      {1, -2, 65504, std::ldexp(1, -24), 0.333251953125, std::numeric_limits<double>::infinity()}};
  EXPECT_EQ(row_of("<f2", "\x00\x3C\x00\xC0\xFF\x7B\x01\x00\x55\x35\x00\x7C"s, 6), expected);
  EXPECT_EQ(row_of(">f2", "\x3C\x00\xC0\x00\x7B\xFF\x00\x01\x35\x55\x7C\x00"s, 6), expected);
  EXPECT_TRUE(std::isnan(row_of("<f2", "\x01\x7E"s, 1)(0, 0)));
}

TEST_F(NpyTest, WritesTheSameBytesAsNumpy) {
  write_npy(at("x.npy"), npy_example());
  EXPECT_EQ(test::bytes_of(at("x.npy")), float64_version_1);
}

TEST_F(NpyTest, WritesVectorsWithTheSameBytesAsNumpy) {
  write_npy_vector(at("v.npy"), Eigen::Vector2d(0, 1.5));
  EXPECT_EQ(test::bytes_of(at("v.npy")),
            "\x93NUMPY\x01\x00v\x00{'descr': '<f8', 'fortran_order': False, 'shape': (2,), }"s + std::string(60, ' ') +
                "\n\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\xf8?"s);
}

TEST_F(NpyTest, RejectsUnsupportedTypesAndNonSquareShapes) {
  for (const char* const type : {"<c8", "<f1", "f8 ", "|O8", "<U3"}) {
    EXPECT_THAT(npy_error_of(npy_replaced(float64_version_1, "<f8", type)),
                AllOf(HasSubstr("x.npy: numbers of type \""s + type), HasSubstr("float64")));
  }
  for (const char* const shape : {"(4, 1)", "(1, 4)", "(4,)  ", "(    )", "(0, 0)"}) {
    EXPECT_THAT(npy_error_of(npy_replaced(float64_version_1, "(2, 2)", shape)), HasSubstr("square distance matrix"));
  }
}

TEST_F(NpyTest, RejectsDataWhoseLengthDoesNotMatchTheHeader) {
  EXPECT_THAT(npy_error_of(float64_version_1 + "x"), HasSubstr("33 bytes of data"));
  EXPECT_THAT(npy_error_of(npy_replaced(float64_version_1, "(2, 2)", "(3, 3)")),
              HasSubstr("shape (3, 3) and type <f8"));
  EXPECT_THAT(npy_error_of(npy_replaced(float64_version_1, "<f8", "<f4")), HasSubstr("32 bytes of data"));
  // 2^32 squared is 0 in 64 bits; 2^64 - 1 is the largest 64-bit number.
  EXPECT_THAT(npy_error_of(npy_replaced(float64_version_1, "(2, 2), }" + std::string(22, ' '),
                                        "(4294967296, 4294967296), }    ")),
              HasSubstr("do not match an array of shape"));
  EXPECT_THAT(npy_error_of(npy_replaced(float64_version_1, "(2, 2), }" + std::string(40, ' '),
                                        "(18446744073709551615, 18446744073709551615), }  ")),
              HasSubstr("do not match an array of shape"));
}

TEST_F(NpyTest, RejectsEveryTruncatedFile) {
  for (const std::string& bytes : {float64_version_1, float32_fortran_version_2}) {
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      EXPECT_THAT(npy_error_of(bytes.substr(0, length)), HasSubstr("x.npy")) << length;
    }
  }
}

RC_GTEST_PROP(NpyFile, IsReadOrNamedInAnErrorIfDamaged, ()) {
  const TemporaryFolder folder;
  std::string bytes = *rc::gen::element(float64_version_1, float32_fortran_version_2);
  const auto changes = *rc::gen::inRange(1, 5);
  for (int i = 0; i < changes; ++i) {
    bytes[*rc::gen::inRange<std::size_t>(0, bytes.size())] = *rc::gen::oneOf(
        rc::gen::arbitrary<char>(), rc::gen::element('9', '(', ')', ',', '\'', '{', '}', ' ', 'L', '\xFF'));
  }
  const std::string error = npy_error_of(bytes);
  RC_ASSERT(error == "no error" || error.find("x.npy") != std::string::npos);
}

RC_GTEST_PROP(NpyFile, IsReadBackAsWritten, ()) {
  const TemporaryFolder folder;
  // A third of a float32 needs the precision of float64.
  const DistanceMatrix matrix = *square_matrices() / 3;
  write_npy(folder.path() / "m.npy", matrix);
  RC_ASSERT(parse_npy(test::bytes_of(folder.path() / "m.npy"), "m", TableShape::square) == matrix);
}

}  // namespace

}  // namespace shapegauge
