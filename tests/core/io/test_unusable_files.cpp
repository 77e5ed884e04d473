// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gmock/gmock.h>
#include <iterator>
#include <random>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/shape_file.h"
#include "tests/core/io/encoded_shapes.h"
#include "tests/core/io/largest_allocation.h"
#include "tests/support/test_files.h"

/// Any file content is either read or raises InputError, with memory proportional to the file's size.
namespace shapegauge {
namespace {

using test::Encoded;
using test::encoded_in_every_format;
using test::tetrahedron;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// True if the file is read, false on InputError; other exceptions fail the test.
bool is_read(const std::filesystem::path& path) {
  bool has_header = true;
  try {
    check_shape_header(path);
  } catch (const InputError&) {
    has_header = false;
  }
  try {
    const Shape shape = read_shape(path);
    EXPECT_TRUE(has_header) << "the check of the header refuses a file that can be read";
    EXPECT_GT(shape.vertices.rows(), 0);
    EXPECT_TRUE(shape.vertices.allFinite());
    EXPECT_TRUE(shape.normals.rows() == 0 || shape.normals.rows() == shape.vertices.rows());
    EXPECT_TRUE(shape.normals.allFinite());
    if (shape.triangles.rows() > 0) {
      EXPECT_GE(shape.triangles.minCoeff(), 0);
      EXPECT_LT(shape.triangles.maxCoeff(), shape.vertices.rows());
    }
    return true;
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "the message is not one line";
    return false;
  }
}

/// A mesh and a point cloud in every format.
std::vector<Encoded> every_format() {
  std::vector<Encoded> all = encoded_in_every_format(tetrahedron());
  std::ranges::copy(test::cloud_in_every_format(test::small_cloud()), std::back_inserter(all));
  return all;
}

using UnusableFiles = test::FolderTest;

TEST_F(UnusableFiles, TruncatedAnywhereAreReadOrGiveAnInputError) {
  for (const auto& [name, bytes, optional] : every_format()) {
    SCOPED_TRACE(name);
    for (std::size_t size = 0; size <= bytes.size(); ++size) {
      const bool read = is_read(folder_.file(name, std::string_view(bytes).substr(0, size)));
      if (optional < bytes.size()) {
        EXPECT_EQ(read, size + optional >= bytes.size()) << size << " bytes";
      }
    }
    EXPECT_TRUE(is_read(folder_.path() / name));
  }
}

TEST_F(UnusableFiles, WithDamagedBytesAreReadOrGiveAnInputError) {
  std::mt19937 random(20240229);
  for (const auto& [name, bytes, optional] : every_format()) {
    SCOPED_TRACE(name);
    std::uniform_int_distribution<std::size_t> position(0, bytes.size() - 1);
    std::uniform_int_distribution<int> value(0, 255);
    int refused = 0;
    for (int i = 0; i < 400; ++i) {
      std::string damaged = bytes;
      for (int k = 0; k <= i % 4; ++k) damaged[position(random)] = static_cast<char>(value(random));
      refused += is_read(folder_.file(name, damaged)) ? 0 : 1;
    }
    EXPECT_GT(refused, 0);
  }
}

TEST_F(UnusableFiles, WithImpossibleCountsAreRejectedWithoutLargeAllocations) {
  const std::string ply_vertices = "element vertex 2000000000\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string ply_faces =
      "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 4000000000000\nproperty list uint int vertex_indices\n";
  const std::string ply_faces_that_may_be = std::regex_replace(ply_faces, std::regex("4000000000000"), "4000000");
  const std::string ply = "ply\nformat binary_little_endian 1.0\n";
  using namespace std::string_literals;
  const std::vector<std::pair<Encoded, std::string>> files = {
      {{"a.off", "OFF\n2000000000 1 0\n0 0 0\n"}, "ends after 1 of 2000000000 vertices"},
      {{"b.off", "OFF\n1 2000000000 0\n0 0 0\n3 0 0 0\n"}, "ends after 1 of 2000000000 faces"},
      {{"c.off", "OFF\n1 1 0\n0 0 0\n2000000000 0 0 0\n"}, "face 0 has more than 100000 vertices"},
      {{"d.off", "OFF BINARY\n\x7F\0\0\0\x7F\0\0\0\0\0\0\0"s}, "ends after 0 of 2130706432 vertices"},
      {{"e.ply", ply + ply_vertices + "end_header\n"}, "ends after 0 of 2000000000 vertices"},
      {{"f.ply", ply + ply_faces + "end_header\n" + std::string(12, '\0')}, "4000000000000 faces: at most 2147483647"},
      {{"g.ply", ply + ply_faces_that_may_be + "end_header\n" + std::string(12, '\0') + "\xFF\xFF\xFF\xFF"},
       "face 0 has more"},
      {{"i.pts", "2000000000\n0 0 0\n"}, "ends after 1 of 2000000000 points"},
      {{"h.stl", std::string(80, ' ') + "\xFF\xFF\xFF\xFF"}, "ends after 0 of 4294967295 facets"}};
  for (const auto& [file, message] : files) {
    const auto path = folder_.file(file.file_name, file.bytes);
    test::reset_largest_allocation();
    EXPECT_THAT([&] { read_shape(path); }, ThrowsMessage<InputError>(HasSubstr(message))) << file.file_name;
    EXPECT_LT(test::largest_allocation(), 100'000U) << file.file_name;
  }
}

}  // namespace
}  // namespace shapegauge
