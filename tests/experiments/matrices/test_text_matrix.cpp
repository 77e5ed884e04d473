#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "shapegauge/experiments/matrices/text_matrix.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/experiments/input_error.h"

namespace shapegauge {
namespace {

using test_io::TemporaryFolder;
using testing::HasSubstr;

DistanceMatrix read(const std::string& text) {
  const TemporaryFolder folder;
  return read_text_matrix(folder.file("m.txt", text));
}

std::string error_of(const std::string& text) {
  return input_error_of([&] { read(text); });
}

TEST(TextMatrix, OneRowALineBetweenAnyBlanks) {
  DistanceMatrix expected(2, 2);
  expected << 0, 1.5, -2.25, std::numeric_limits<double>::infinity();
  EXPECT_EQ(read("0 1.5\n-2.25 inf\n"), expected);
  EXPECT_EQ(read("\xEF\xBB\xBF# distances\r\n\r\n\t0.0  1.50 \r\n  # more\r\n-225e-2\tInf"), expected);
}

TEST(TextMatrix, OneNumberIsAMatrix) { EXPECT_EQ(read("0"), DistanceMatrix::Zero(1, 1)); }

TEST(TextMatrix, AFaultIsOneErrorWithItsLine) {
  EXPECT_THAT(error_of("0 1\n1 x\n"), HasSubstr("m.txt:2: \"x\" is not a number (number 2 of the row)"));
  EXPECT_THAT(error_of("0,1\n1,0\n"), HasSubstr("m.txt:1: \"0,1\" is not a number"));
  EXPECT_THAT(error_of("0 1\n\n1\n"), HasSubstr("m.txt:3: the row has 1 numbers, but the one in line 1 has 2"));
  EXPECT_THAT(error_of("0 1\n1 0 2\n"), HasSubstr("m.txt:2: the row has 3 numbers"));
  EXPECT_THAT(error_of("0 1\n1 0\n2 3\n"), HasSubstr("m.txt:3: a distance matrix is square, but this is row 3"));
  EXPECT_THAT(error_of("0 1 2\n1 0 2\n"),
              HasSubstr("m.txt: a distance matrix is square, but the file has 2 rows of 3"));
  EXPECT_THAT(error_of("# nothing\n"), HasSubstr("m.txt: the file has no numbers"));
  EXPECT_THAT(error_of(""), HasSubstr("empty"));
}

TEST(TextMatrix, EveryPrefixReadsOrIsAnInputError) {
  const std::string valid = "# three models\n0 1.25 2e-1\n1.25 0 3\n2e-1 3 0\n";
  const std::size_t first_number = valid.find('0');
  for (std::size_t length = 0; length < valid.size(); ++length) {
    // One number alone is a matrix too, and the last line end may be missing.
    const bool alone = length == first_number + 1 || length == first_number + 2;
    const bool whole = length + 1 == valid.size();
    EXPECT_THAT(error_of(valid.substr(0, length)), HasSubstr(alone || whole ? "no error" : "m.txt")) << length;
  }
}

}  // namespace
}  // namespace shapegauge
