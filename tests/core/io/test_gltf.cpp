// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/LU>
#include <cstring>
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/shape_file.h"
#include "tests/support/test_files.h"

namespace shapegauge {
namespace {

using testing::HasSubstr;

/// Little-endian bytes of numbers.
template <typename Number>
std::string bytes_of(const std::vector<Number>& numbers) {
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

/// Vertices and faces of a tetrahedron in one buffer of 72 bytes.
std::string tetrahedron_bytes() {
  return bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) +
         bytes_of<std::uint16_t>({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
}

/// A document with the tetrahedron as its only mesh; `more`: additional members of the document.
std::string document(const std::string& nodes, const std::string& buffer = R"("uri": "tetrahedron.bin", )",
                     const std::string& more = "") {
  return fmt::format(R"({{"asset": {{"version": "2.0"}}, {}"scene": 0, "scenes": [{{"nodes": [0]}}], "nodes": [{}],
    "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "indices": 1}}]}}],
    "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"}},
                  {{"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}}],
    "bufferViews": [{{"buffer": 0, "byteLength": 48}}, {{"buffer": 0, "byteOffset": 48, "byteLength": 24}}],
    "buffers": [{{{}"byteLength": 72}}]}})",
                     more, nodes, buffer);
}

std::string with_change(std::string text, const std::string& from, const std::string& to) {
  const std::size_t position = text.find(from);
  EXPECT_NE(position, std::string::npos) << from;
  return text.replace(position, from.size(), to);
}

class GltfReader : public test::FolderTest {
 protected:
  void SetUp() override { test::write_text(at("tetrahedron.bin"), tetrahedron_bytes()); }

  Shape read(const std::string& json) const {
    test::write_text(at("shape.gltf"), json);
    return read_shape(at("shape.gltf"));
  }

  std::string error_of(const std::string& json) const {
    return test::input_error_of([&] { read(json); });
  }
};

double volume_of(const Shape& shape) {
  double six = 0;
  for (const auto& triangle : shape.triangles.rowwise()) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) corners.row(k) = shape.vertices.row(triangle[k]);
    six += corners.determinant();
  }
  return six / 6;
}

TEST_F(GltfReader, ReadsABufferInAnotherFile) {
  const Shape shape = read(document(R"({"mesh": 0})"));
  ASSERT_EQ(shape.vertices.rows(), 4);
  ASSERT_EQ(shape.triangles.rows(), 4);
  EXPECT_EQ(shape.vertices.row(3), Eigen::RowVector3d(0, 0, 1));
  EXPECT_EQ(shape.triangles.row(1), (Eigen::RowVector3i(0, 1, 3)));
  EXPECT_DOUBLE_EQ(volume_of(shape), 1.0 / 6);
  EXPECT_THAT(gltf_format().neighbours(read_shape_source(at("shape.gltf"))), testing::ElementsAre("tetrahedron.bin"));
}

TEST_F(GltfReader, AppliesNodeTransforms) {
  // Scaled by 2 along x, rotated by 90 degrees about z, then translated by the parent.
  const Shape shape = read(document(R"({"children": [1, 2], "translation": [10, 0, 0]},
      {"mesh": 0, "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476], "scale": [2, 1, 1]},
      {"mesh": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 5, 0, 1]})"));
  ASSERT_EQ(shape.vertices.rows(), 8);
  EXPECT_TRUE(shape.vertices.row(1).isApprox(Eigen::RowVector3d(10, 2, 0)));
  EXPECT_TRUE(shape.vertices.row(5).isApprox(Eigen::RowVector3d(11, 5, 0)));
  EXPECT_EQ(shape.triangles.row(5), (Eigen::RowVector3i(4, 5, 7)));
}

TEST_F(GltfReader, ReversesTrianglesOfMirroredNodes) {
  EXPECT_DOUBLE_EQ(volume_of(read(document(R"({"mesh": 0, "scale": [-3, 1, 1]})"))), 0.5);
}

TEST_F(GltfReader, ReadsBinaryFilesAndDataUris) {
  std::string json = document(R"({"mesh": 0})", "");
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string data = tetrahedron_bytes();
  const auto chunk = [](const std::string& bytes, const std::string& type) {
    return bytes_of<std::uint32_t>({static_cast<std::uint32_t>(bytes.size())}) + type + bytes;
  };
  const std::string chunks = chunk(json, "JSON") + chunk(data, std::string("BIN\0", 4));
  const std::string file =
      "glTF" + bytes_of<std::uint32_t>({2, static_cast<std::uint32_t>(12 + chunks.size())}) + chunks;
  EXPECT_DOUBLE_EQ(volume_of(read_gltf({.bytes = file, .name = "x.glb"})), 1.0 / 6);
  EXPECT_TRUE(is_recognised_shape({.bytes = file, .name = "no extension"}));
  const std::string uri =
      "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/"
      "AAACAAEAAAABAAMAAAADAAIAAQACAAMA";
  EXPECT_DOUBLE_EQ(volume_of(read(document(R"({"mesh": 0})", "\"uri\": \"" + uri + "\", "))), 1.0 / 6);
}

TEST_F(GltfReader, ReadsStripsFansAndPoints) {
  const std::string nodes = R"({"mesh": 0})";
  const auto with_mode = [&](int mode) {
    return read(with_change(document(nodes), R"("indices": 1)", fmt::format(R"("mode": {})", mode)));
  };
  const Shape strip = with_mode(5);
  ASSERT_EQ(strip.triangles.rows(), 2);
  EXPECT_EQ(strip.triangles.row(1), (Eigen::RowVector3i(1, 3, 2)));
  const Shape fan = with_mode(6);
  EXPECT_EQ(fan.triangles.row(1), (Eigen::RowVector3i(2, 3, 0)));
  const Shape cloud = with_mode(0);
  EXPECT_TRUE(is_cloud(cloud));
  EXPECT_EQ(cloud.vertices.rows(), 4);
}

TEST_F(GltfReader, ReadsNormalisedIntegers) {
  // The tetrahedron in bytes, of which 127 is 1; -127 and -128 are both -1.
  test::write_text(at("tetrahedron.bin"), bytes_of<std::int8_t>({0, 0, 0, 127, 0, -128, 0, 127, -127, 0, 0, 127}) +
                                              std::string(36, '\0') +
                                              bytes_of<std::uint16_t>({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}));
  const Shape shape = read(with_change(document(R"({"mesh": 0})"), R"("componentType": 5126, )",
                                       R"("componentType": 5120, "normalized": true, )"));
  ASSERT_EQ(shape.vertices.rows(), 4);
  EXPECT_EQ(shape.vertices.row(1), Eigen::RowVector3d(1, 0, -1));
  EXPECT_EQ(shape.vertices.row(2), Eigen::RowVector3d(0, 1, -1));
  EXPECT_EQ(shape.vertices.row(3), Eigen::RowVector3d(0, 0, 1));
}

TEST_F(GltfReader, ReplacesPositionsBySparseAccessors) {
  // Vertex 2 moves to (7, 8, 9): an index and a position behind the tetrahedron.
  test::write_text(at("tetrahedron.bin"),
                   tetrahedron_bytes() + bytes_of<std::uint32_t>({2}) + bytes_of<float>({7, 8, 9}));
  std::string json = with_change(document(R"({"mesh": 0})"), R"("type": "VEC3")",
                                 R"("type": "VEC3", "sparse": {"count": 1,
      "indices": {"bufferView": 2, "componentType": 5125}, "values": {"bufferView": 3}})");
  json = with_change(json, R"({"buffer": 0, "byteOffset": 48, "byteLength": 24})",
                     R"({"buffer": 0, "byteOffset": 48, "byteLength": 24},
      {"buffer": 0, "byteOffset": 72, "byteLength": 4}, {"buffer": 0, "byteOffset": 76, "byteLength": 12})");
  json = with_change(json, R"("byteLength": 72})", R"("byteLength": 88})");
  const Shape shape = read(json);
  ASSERT_EQ(shape.vertices.rows(), 4);
  EXPECT_EQ(shape.vertices.row(1), Eigen::RowVector3d(1, 0, 0));
  EXPECT_EQ(shape.vertices.row(2), Eigen::RowVector3d(7, 8, 9));
  // Without a buffer view the other positions are zeros.
  const Shape zeros = read(with_change(json, R"("bufferView": 0, "componentType": 5126)", R"("componentType": 5126)"));
  EXPECT_EQ(zeros.vertices.row(1), Eigen::RowVector3d(0, 0, 0));
  EXPECT_EQ(zeros.vertices.row(2), Eigen::RowVector3d(7, 8, 9));
}

TEST_F(GltfReader, RejectsInconsistentCountsInvalidIndicesAndUnsupportedExtensions) {
  const std::string whole = document(R"({"mesh": 0})");
  EXPECT_THAT(error_of(with_change(whole, R"("count": 4)", R"("count": 5)")), HasSubstr("buffer view 0"));
  EXPECT_THAT(error_of(with_change(whole, R"("byteLength": 24)", R"("byteLength": 2400)")), HasSubstr("buffer view 1"));
  EXPECT_THAT(error_of(with_change(whole, R"("mesh": 0)", R"("mesh": 7)")), HasSubstr("mesh 7"));
  for (const char* const type : {"5126", "5122"}) {
    EXPECT_THAT(error_of(with_change(whole, "5123", type)), HasSubstr("indices"));
  }
  EXPECT_THAT(error_of(with_change(whole, "SCALAR", "VEC2")), HasSubstr("indices"));
  EXPECT_THAT(error_of(with_change(whole, R"({"mesh": 0})", R"({"mesh": 0, "children": [0]})")), HasSubstr("node 0"));
  EXPECT_THAT(error_of(with_change(whole, "tetrahedron.bin", "absent.bin")), HasSubstr("absent.bin"));
  EXPECT_THAT(error_of(with_change(whole, "tetrahedron.bin", "../secret.bin")), HasSubstr("out of the folder"));
  EXPECT_THAT(error_of(with_change(whole, "tetrahedron.bin", "https://example.org/x.bin")), HasSubstr("not fetched"));
  EXPECT_THAT(error_of(document(R"({"mesh": 0})", R"("uri": "tetrahedron.bin", )",
                                R"("extensionsRequired": ["KHR_draco_mesh_compression"], )")),
              HasSubstr("compress"));
  const std::string uri = R"("uri": "tetrahedron.bin", )";
  EXPECT_THAT(error_of(document(R"({"mesh": 0})", uri, R"("extensionsRequired": ["EXT_mesh_gpu_instancing"], )")),
              HasSubstr("EXT_mesh_gpu_instancing"));
  EXPECT_EQ(
      read(document(R"({"mesh": 0})", uri, R"("extensionsRequired": ["KHR_materials_unlit"], )")).triangles.rows(), 4);
  test::write_text(at("tetrahedron.bin"), with_change(tetrahedron_bytes(), bytes_of<std::uint16_t>({1, 2, 3}),
                                                      bytes_of<std::uint16_t>({1, 2, 4})));
  EXPECT_THAT(error_of(whole), HasSubstr("vertex 4"));
}

TEST_F(GltfReader, RejectsDeeplyNestedJson) {
  const std::string deep(100'000, '[');
  EXPECT_THAT(error_of(document(R"({"mesh": 0, "extras": )" + deep + "}")), HasSubstr("nested"));
}

}  // namespace
}  // namespace shapegauge
