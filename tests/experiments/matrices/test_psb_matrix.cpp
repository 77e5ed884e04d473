#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <string>

#include "shapegauge/experiments/matrices/psb_matrix.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/experiments/input_error.h"
#include "tests/experiments/matrices/random_matrices.h"

namespace shapegauge {
namespace {

using test_io::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

TEST(PsbMatrix, IsLittleEndianFloat32RowByRow) {
  using namespace std::string_literals;
  const TemporaryFolder folder;
  const auto bytes = "\0\0\0\0"s + "\0\0\xC0\x3F"s + "\0\0\x10\xC0"s + "\0\0\x80\x7F"s;
  const DistanceMatrix matrix = read_psb_matrix(folder.file("m.matrix", bytes));
  DistanceMatrix expected(2, 2);
  expected << 0, 1.5, -2.25, std::numeric_limits<double>::infinity();
  EXPECT_EQ(matrix, expected);
  write_psb_matrix(folder.path() / "w.matrix", expected);
  EXPECT_EQ(test_io::bytes_of(folder.path() / "w.matrix"), bytes);
}

TEST(PsbMatrix, AnotherSizeIsAnErrorThatKnowsFloat64) {
  const TemporaryFolder folder;
  const auto error_for = [&](std::size_t bytes) {
    return input_error_of([&] { read_psb_matrix(folder.file("m.matrix", std::string(bytes, '\0'))); });
  };
  EXPECT_THAT(error_for(8 * 9), AllOf(HasSubstr("m.matrix: 72 bytes"), HasSubstr("looks like float64 (3 x 3)")));
  EXPECT_THAT(error_for(4 * 9 - 1), AllOf(HasSubstr("m.matrix: 35 bytes"), HasSubstr("cut off")));
  EXPECT_THAT(error_for(4 * 10), HasSubstr("no square matrix"));
  EXPECT_THAT(error_for(3), HasSubstr("no square matrix"));
  EXPECT_THAT(error_for(0), HasSubstr("empty"));
  EXPECT_THAT(input_error_of([&] { read_psb_matrix(folder.path() / "none.matrix"); }), HasSubstr("none.matrix"));
}

TEST(PsbMatrix, EverySizeOfFileReadsOrIsAnError) {
  const TemporaryFolder folder;
  for (std::size_t bytes = 1; bytes <= 400; ++bytes) {
    const auto path = folder.file("m.matrix", std::string(bytes, '\0'));
    std::size_t size = 1;
    while (4 * size * size < bytes) ++size;
    const std::string error = input_error_of([&] {
      EXPECT_EQ(read_psb_matrix(path),
                DistanceMatrix::Zero(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(size)));
    });
    EXPECT_EQ(error == "no error", 4 * size * size == bytes) << bytes;
  }
}

TEST(PsbMatrix, ADistanceBeyondFloat32IsNotWritten) {
  const TemporaryFolder folder;
  DistanceMatrix matrix = DistanceMatrix::Zero(3, 3);
  matrix(1, 2) = 1e39;
  EXPECT_THAT(input_error_of([&] { write_psb_matrix(folder.path() / "m.matrix", matrix); }),
              AllOf(HasSubstr("m.matrix"), HasSubstr("row 1, column 2")));
  EXPECT_EQ(folder.size(), 0U);
}

RC_GTEST_PROP(PsbMatrix, ReadsBackWhatIsWritten, ()) {
  const TemporaryFolder folder;
  const DistanceMatrix matrix = *square_matrices();
  write_psb_matrix(folder.path() / "m.matrix", matrix);
  RC_ASSERT(read_psb_matrix(folder.path() / "m.matrix") == matrix);
}

}  // namespace
}  // namespace shapegauge
