// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/segmentation/seg_file.h"
#include "tests/support/test_files.h"

namespace shapegauge {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class SegFile : public ::testing::Test {
 protected:
  /// A mesh with the given number of triangles.
  static Shape mesh_of(Eigen::Index triangles) {
    return {.vertices = Points::Zero(3, 3), .triangles = Triangles::Zero(triangles, 3)};
  }

  void write(const std::string& text) const { test::write_text(path_, text); }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "parts.seg";
};

TEST_F(SegFile, IsReadBackAsWritten) {
  const std::vector<std::int32_t> labels = {0, 3, 3, 2147483647};
  write_seg(path_, labels);
  EXPECT_EQ(read_seg(path_, mesh_of(4)), labels);
}

TEST_F(SegFile, HasOneLinePerPolygon) {
  Shape mesh = mesh_of(3);
  mesh.vertices << 0, 0, 0, 1, 0, 0, 0, 1, 0;
  mesh.triangles.rowwise() = Eigen::RowVector3<std::int32_t>(0, 1, 2);
  mesh.polygons = {.of_triangle = {0, 2, 2}, .count = 3};
  write_seg(path_, mesh, std::vector<std::int32_t>{4, 6, 6});
  EXPECT_EQ(test::text_of(path_), "4\n0\n6\n");
  EXPECT_EQ(read_seg(path_, mesh), (std::vector<std::int32_t>{4, 6, 6}));
  write("4\n6\n");
  EXPECT_THAT([&] { read_seg(path_, mesh); }, ThrowsMessage<InputError>(HasSubstr("3 faces")));
}

TEST_F(SegFile, AcceptsCarriageReturnsAtLineEnds) {
  write("1\r\n2\r\n");
  EXPECT_EQ(read_seg(path_, mesh_of(2)), (std::vector<std::int32_t>{1, 2}));
}

TEST_F(SegFile, RejectsAMeshWithAnotherNumberOfFaces) {
  write("1\n2\n3\n");
  EXPECT_THAT([&] { read_seg(path_, mesh_of(4)); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("3 lines"), HasSubstr("4 faces"))));
  EXPECT_THAT([&] { read_seg(path_, mesh_of(2)); },
              ThrowsMessage<InputError>(AllOf(HasSubstr(":3:"), HasSubstr("(2)"))));
}

TEST_F(SegFile, RejectsInvalidLabelsAndReportsTheLineNumber) {
  for (const std::string word : {"-1", "2147483648", "99999999999999999999", "1.5", "x"}) {
    write("1\n" + word + "\n");
    EXPECT_THAT([&] { read_seg(path_, mesh_of(2)); }, ThrowsMessage<InputError>(HasSubstr(":2:"))) << word;
  }
}

TEST_F(SegFile, ReportsThePathOfAMissingFile) {
  EXPECT_THAT([&] { read_seg(path_, mesh_of(2)); }, ThrowsMessage<InputError>(HasSubstr(path_.string())));
}

}  // namespace
}  // namespace shapegauge
