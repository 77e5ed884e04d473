#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "shapegauge/experiments/matrices/csv_matrix.h"
#include "shapegauge/experiments/matrices/distance_matrix_file.h"
#include "shapegauge/experiments/matrices/npy.h"
#include "shapegauge/experiments/matrices/psb_matrix.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/experiments/input_error.h"

namespace shapegauge {
namespace {

using test_io::TemporaryFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

DistanceMatrix example() {
  DistanceMatrix matrix(2, 2);
  matrix << 0, 1.5, -2.25, std::numeric_limits<double>::infinity();
  return matrix;
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
  for (const char* const name : {"m.mat", "m", "npy"}) {
    EXPECT_THAT(input_error_of([&] { read_distance_matrix(name); }),
                AllOf(HasSubstr(name), HasSubstr(".matrix, .npy, .csv, .txt, .dat")));
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
    EXPECT_THAT(input_error_of([&] { read_distance_matrix(path); }),
                AllOf(HasSubstr(path.string()), HasSubstr("row 2, column 1")));
  }
}

TEST(ReadDistanceMatrix, AMissingFileOrAFolderIsAnInputError) {
  const TemporaryFolder folder;
  EXPECT_THAT(input_error_of([&] { read_distance_matrix(folder.path() / "none.npy"); }), HasSubstr("none.npy"));
  std::filesystem::create_directory(folder.path() / "folder.npy");
  EXPECT_THAT(input_error_of([&] { read_distance_matrix(folder.path() / "folder.npy"); }), HasSubstr("folder"));
}

}  // namespace
}  // namespace shapegauge
