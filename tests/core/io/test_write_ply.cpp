#include <cmath>
#include <cstring>
#include <gmock/gmock.h>
#include <limits>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/read_shape.h"
#include "shapegauge/core/io/write_ply.h"
#include "tests/core/io/encoded_shapes.h"
#include "tests/core/io/temporary_folder.h"

namespace shapegauge {
namespace {

using test_io::tetrahedron;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

const std::vector<Colour> colours = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {250, 251, 252}};

Eigen::VectorXd values() { return Eigen::Vector4d(0.1, -2.5, std::numeric_limits<double>::quiet_NaN(), 1e300); }

double double_at(const std::string& bytes, std::size_t offset) {
  double value = 0;
  std::memcpy(&value, bytes.substr(offset, sizeof(value)).data(), sizeof(value));
  return value;
}

/// Checks colours and values of the records that begin at `offset`, of `stride` bytes, after `skip` bytes in each.
void expect_samples(const std::string& bytes, std::size_t offset, std::size_t stride, std::size_t skip) {
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t record = offset + i * stride + skip;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      EXPECT_EQ(static_cast<std::uint8_t>(bytes.at(record + channel)), colours[i][channel]);
    }
    const double value = double_at(bytes, record + 3);
    const double expected = values()[static_cast<Eigen::Index>(i)];
    EXPECT_TRUE(value == expected || (std::isnan(value) && std::isnan(expected))) << value;
  }
}

TEST(WritePly, ColoursAndValuesAtFaces) {
  const test_io::TemporaryFolder folder;
  const auto path = folder.path() / "t.ply";
  write_ply(path, tetrahedron(), SampleSite::faces, values(), colours);
  test_io::expect_same(read_shape(path), tetrahedron());
  const std::string bytes = test_io::bytes_of(path);
  EXPECT_THAT(bytes,
              HasSubstr("element face 4\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar "
                        "green\nproperty uchar blue\nproperty double sdf\nend_header\n"));
  const std::size_t body = bytes.find("end_header\n") + 11;
  constexpr std::size_t vertex = 3 * 8;
  constexpr std::size_t face = 1 + 3 * 4 + 3 + 8;
  ASSERT_EQ(bytes.size(), body + 4 * (vertex + face));
  expect_samples(bytes, body + 4 * vertex, face, 13);
}

TEST(WritePly, ColoursAndValuesAtVertices) {
  const test_io::TemporaryFolder folder;
  const auto path = folder.path() / "t.ply";
  write_ply(path, tetrahedron(), SampleSite::vertices, values(), colours);
  test_io::expect_same(read_shape(path), tetrahedron());
  const std::string bytes = test_io::bytes_of(path);
  const std::size_t body = bytes.find("end_header\n") + 11;
  constexpr std::size_t vertex = 3 * 8 + 3 + 8;
  ASSERT_EQ(bytes.size(), body + 4 * (vertex + 13));
  expect_samples(bytes, body, vertex, 24);
}

TEST(WritePly, CloudsWithAndWithoutValues) {
  const test_io::TemporaryFolder folder;
  const auto path = folder.path() / "t.ply";
  write_ply(path, test_io::small_cloud(), SampleSite::vertices, values(), colours);
  test_io::expect_same(read_shape(path), test_io::small_cloud());
  const std::string bytes = test_io::bytes_of(path);
  EXPECT_THAT(bytes, Not(HasSubstr("element face")));
  const std::size_t body = bytes.find("end_header\n") + 11;
  constexpr std::size_t point = 6 * 8 + 3 + 8;
  ASSERT_EQ(bytes.size(), body + 4 * point);
  expect_samples(bytes, body, point, 48);
  write_ply(path, test_io::small_cloud());
  test_io::expect_same(read_shape(path), test_io::small_cloud());
}

TEST(WritePly, MeshWithoutValues) {
  const test_io::TemporaryFolder folder;
  const auto path = folder.path() / "t.ply";
  write_ply(path, tetrahedron());
  test_io::expect_same(read_shape(path), tetrahedron());
  EXPECT_THAT(test_io::bytes_of(path), Not(HasSubstr("sdf")));
}

TEST(WritePly, WrongNumberOfValuesOrColoursIsAnError) {
  const test_io::TemporaryFolder folder;
  Shape shape = tetrahedron();
  shape.triangles.conservativeResize(3, 3);
  EXPECT_THAT([&] { write_ply(folder.path() / "t.ply", shape, SampleSite::faces, values(), colours); },
              ThrowsMessage<InputError>(EndsWith("4 values and 4 colours for 3 samples")));
}

}  // namespace
}  // namespace shapegauge
