#include <array>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>

#include "shapegauge/experiments/matrices/npy_header.h"
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
}  // namespace shapegauge
