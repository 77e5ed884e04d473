// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <gmock/gmock.h>
#include <limits>
#include <string>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/little_endian.h"
#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/io/shape_format.h"
#include "tests/core/io/encoded_shapes.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using test::as_ascii_ply;
using test::as_binary_ply;
using test::expect_same;
using test::tetrahedron;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

constexpr std::array both_orders = {std::endian::little, std::endian::big};

const std::string vertex_header = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string face_header = "element face 4\nproperty list uchar int vertex_index\n";
const std::string ply_vertices = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string ply_faces = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

std::string ascii(const std::string& header, const std::string& body) {
  return "ply\nformat ascii 1.0\n" + header + "end_header\n" + body;
}

std::string replaced_once(std::string text, const std::string& what, const std::string& with) {
  return text.replace(text.find(what), what.size(), with);
}

TEST(ReadPly, ReadsAsciiFiles) {
  expect_same(read_ply(ascii(vertex_header + face_header, ply_vertices + ply_faces), "t.ply"), tetrahedron());
}

TEST(ReadPly, IgnoresUnknownPropertiesAndElements) {
  expect_same(read_ply(as_ascii_ply(tetrahedron()), "t.ply"), tetrahedron());
}

TEST(ReadPly, ReadsBinaryFilesOfEitherByteOrderAndPrecision) {
  Shape shape = tetrahedron();
  shape.vertices(1, 0) = 1.0 + 1e-15;
  for (const std::endian order : both_orders) {
    expect_same(read_ply(as_binary_ply(shape, order, true), "t.ply"), shape);
    expect_same(read_ply(as_binary_ply(tetrahedron(), order, false), "t.ply"), tetrahedron());
  }
}

TEST(ReadPly, AcceptsABinaryBodyThatBeginsWithALineFeed) {
  // 2.0f with a last byte of 0x0A or 0x0D is the body's first byte in little-endian order.
  for (const std::string line_end : {"\n", "\r", "\r\n"}) {
    for (const char first : {'\n', '\r'}) {
      const std::vector<std::string> lines = {"ply",
                                              "format binary_little_endian 1.0",
                                              "element vertex 1",
                                              "property float x",
                                              "property float y",
                                              "property float z",
                                              "end_header"};
      std::string bytes;
      for (const std::string& line : lines) bytes += line + line_end;
      bytes += first + std::string("\0\0\x40", 3) + std::string(8, '\0');
      const Shape shape = read_ply(bytes, "t.ply");
      EXPECT_EQ(shape.vertices(0, 0), 2 + 0x1p-22 * first);
    }
  }
}

TEST(ReadPly, AcceptsNanInUnusedProperties) {
  const Shape shape =
      read_ply(ascii("element vertex 1\nproperty float quality\nproperty float x\nproperty float y\nproperty "
                     "float z\n",
                     "nan 1 2 3\n"),
               "t.ply");
  EXPECT_EQ(shape.vertices, (Points(1, 3) << 1, 2, 3).finished());
}

TEST(ReadPly, AcceptsFacesBeforeVertices) {
  expect_same(read_ply(ascii(face_header + vertex_header, ply_faces + ply_vertices), "t.ply"), tetrahedron());
}

TEST(ReadPly, AcceptsIntegerCoordinatesInAnyOrder) {
  const Shape shape =
      read_ply(ascii("element vertex 1\nproperty int z\nproperty short x\nproperty uchar y\n", "3 1 2\n"), "t");
  EXPECT_EQ(shape.vertices, (Points(1, 3) << 1, 2, 3).finished());
}

TEST(ReadPly, SplitsPolygonsIntoFansAndDropsFacesBelowThreeCorners) {
  const Shape shape =
      read_ply(ascii(vertex_header + face_header, ply_vertices + "4 3 2 1 0\n2 0 1\n1 3\n0\n"), "t.ply");
  EXPECT_EQ(shape.triangles, (Triangles(2, 3) << 3, 2, 1, 3, 1, 0).finished());
}

TEST(ReadPly, FileWithoutFacesIsAPointCloud) {
  for (const std::string header : {"", "element face 0\n"}) {
    const Shape shape = read_ply(ascii(vertex_header + header, ply_vertices), "t.ply");
    EXPECT_EQ(shape.vertices, tetrahedron().vertices);
    EXPECT_EQ(shape.triangles.rows(), 0);
  }
}

TEST(ReadPly, ReadsTheNormalsOfACloud) {
  const std::string header = replaced_once(vertex_header, "4\n", "2\nproperty float nz\nproperty float nx\n");
  const std::string body = "2 0 0 0 0 0\n0 0 1 0 0 0\n";
  EXPECT_EQ(read_ply(ascii(header + "property float ny\n", body), "t.ply").normals,
            (Points(2, 3) << 0, 0, 1, 0, 0, 0).finished());
  EXPECT_EQ(read_ply(ascii(header + "property float n\n", body), "t.ply").normals.rows(), 0);  // no ny
}

TEST(ReadPly, IgnoresNanNormalsOfAMesh) {
  const std::string header = vertex_header + "property float nx\nproperty float ny\nproperty float nz\n";
  const std::string lines = "0 0 0 nan 0 0\n1 0 0 0 0 0\n0 1 0 0 0 0\n0 0 1 0 0 0\n";
  expect_same(read_ply(ascii(header + face_header, lines + ply_faces), "t.ply"), tetrahedron());
}

TEST(ReadPly, ReadsTriangleStrips) {
  const std::string header = vertex_header + "element tristrips 1\nproperty list int int vertex_indices\n";
  const Shape shape = read_ply(ascii(header, ply_vertices + "9 0 1 2 3 3 -1 1 3 2\n"), "t.ply");
  EXPECT_EQ(shape.triangles, (Triangles(3, 3) << 0, 1, 2, 2, 1, 3, 1, 3, 2).finished());
}

TEST(ReadPly, RefusesInvalidHeaders) {
  const std::string plane = "element vertex 1\nproperty float x\nproperty float y\n";
  const std::string faces = vertex_header + "element face 1\nproperty ";
  test::expect_refused(
      {{"OFF\n", "t.ply:1: not a PLY file"},
       {"ply\nformat ascii 1.0\nelement vertex 4\n", "ends within its header"},
       {"ply\nformat binary 1.0\n", "t.ply:2: unknown format \"binary\""},
       {"ply\n" + vertex_header + "end_header\n", "t.ply:6: the header has no line \"format\""},
       {ascii("element vertex 4\nproperty real x\n", ""), "t.ply:4: unknown type \"real\""},
       {ascii("property float x\n", ""), "t.ply:3: expected an element before the first property"},
       {ascii("element vertex -4\n", ""), "t.ply:3: the number of elements cannot be -4"},
       {ascii("hello\n", ""), "t.ply:3: unknown keyword \"hello\""},
       {ascii(face_header, ply_faces), "no element \"vertex\""},
       {ascii(vertex_header + vertex_header, ""), "two elements \"vertex\""},
       {ascii(plane, "0 0\n"), "one property \"z\""},
       {ascii(vertex_header + face_header + face_header, ""), "two elements \"face\""},
       {ascii("element vertex 3000000000\nproperty float x\n", ""), "at most 2147483647"},
       {ascii(faces + "int a\n", ply_vertices + "1\n"), "no list \"vertex_indices\""},
       {ascii(faces + "list uchar float vertex_indices\n", ply_vertices), "integer type"},
       {ascii(vertex_header + face_header + "property list uchar float vertex_indices\n", ""), "two lists"},
       {ascii(faces + "list float int vertex_indices\n", ply_vertices), "t.ply:8: the length of a list"}},
      [](const std::string& bytes) { read_ply(bytes, "t.ply"); });
}

TEST(ReadPly, RefusesInvalidAsciiBodies) {
  const std::string header = vertex_header + face_header;
  const std::string one_face = vertex_header + "element face 1\nproperty list ";
  const std::string strips = vertex_header + "element tristrips 1\nproperty list int int vertex_indices\n";
  const std::string normals = "property float nx\nproperty float ny\nproperty float nz\n";
  const std::string text = ascii(header, ply_vertices + ply_faces);
  test::expect_refused(
      {{ascii(one_face + "uchar int vertex_indices\n", ply_vertices + "2 0 1\n"), "t.ply:14: none of its 1 faces"},
       {ascii(one_face + "char int vertex_indices\n", ply_vertices + "-2 0 1\n"), "t.ply:14: face 0 cannot have -2"},
       {ascii(strips, ply_vertices + "3 0 1 9\n"), "t.ply:14: face 0 refers to vertex 9"},
       {text + "3 0 1 2\n", "more data follow"},
       {ascii(one_face + "uchar int vertex_indices\n", ply_vertices + "3 0 1 2 255\n"), "more data follow"},
       {text.substr(0, text.find("0 0 1\n") + 3), "t.ply:13: ends after 3 of 4 vertices"},
       {text.substr(0, text.find("3 1 2 3") + 5), "t.ply:17: ends after 3 of 4 faces"},
       {ascii(header, ply_vertices + replaced_once(ply_faces, "0 1 3", "0 1 4")),
        "t.ply:15: face 1 refers to vertex 4"},
       {replaced_once(text, "1 0 0", "1 nan 0"), "t.ply:11: a coordinate is not a finite number"},
       {ascii(vertex_header + normals, "0 0 0 0 0 nan\n"), "t.ply:11: a coordinate is not a finite number"}},
      [](const std::string& bytes) { read_ply(bytes, "t.ply"); });
}

TEST(ReadPly, RefusesInvalidBinaryFiles) {
  Shape wrong_index = tetrahedron();
  wrong_index.triangles(2, 0) = 4;
  Shape not_finite = tetrahedron();
  not_finite.vertices(2, 0) = std::numeric_limits<double>::quiet_NaN();
  Shape cloud = test::small_cloud();
  cloud.normals(1, 1) = std::numeric_limits<double>::infinity();
  const auto files = test::cloud_in_every_format(cloud);
  for (const std::endian order : both_orders) {
    const std::string bytes = as_binary_ply(tetrahedron(), order, false);
    const std::size_t body = bytes.find("end_header\n") + 11;
    test::expect_refused(
        {{bytes.substr(0, bytes.size() - 1), "3 of 4 faces"},
         {bytes + bytes, "more data follow"},
         {bytes.substr(0, body + 20), "1 of 4 vertices"},
         {bytes.substr(0, body + std::size_t{4} * 18 + 5), "0 of 1 items of its element \"camera\""},
         {as_binary_ply(wrong_index, order, true), "face 2 refers to vertex 4"},
         {as_binary_ply(not_finite, order, false), "vertex 2 has a coordinate"},
         {std::ranges::find(files, "binary.ply", &test::Encoded::file_name)->bytes, "vertex 1 has a normal"}},
        [](const std::string& damaged) { read_ply(damaged, "t.ply"); });
  }
}

const std::vector<std::array<std::uint8_t, 3>> colours = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {250, 251, 252}};

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

using WritePly = test::FolderTest;

TEST_F(WritePly, WritesColoursAndValuesOfFaces) {
  const auto path = at("t.ply");
  write_ply(path, tetrahedron(), SampleSite::faces, values(), colours);
  test::expect_same(read_shape(path), tetrahedron());
  const std::string bytes = test::bytes_of(path);
  EXPECT_THAT(bytes,
              HasSubstr("element face 4\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar "
                        "green\nproperty uchar blue\nproperty double sdf\nend_header\n"));
  const std::size_t body = bytes.find("end_header\n") + 11;
  constexpr std::size_t vertex = 3 * 8;
  constexpr std::size_t face = 1 + 3 * 4 + 3 + 8;
  ASSERT_EQ(bytes.size(), body + 4 * (vertex + face));
  expect_samples(bytes, body + 4 * vertex, face, 13);
}

TEST_F(WritePly, WritesColoursAndValuesOfVertices) {
  const auto path = at("t.ply");
  write_ply(path, tetrahedron(), SampleSite::vertices, values(), colours);
  test::expect_same(read_shape(path), tetrahedron());
  const std::string bytes = test::bytes_of(path);
  const std::size_t body = bytes.find("end_header\n") + 11;
  constexpr std::size_t vertex = 3 * 8 + 3 + 8;
  ASSERT_EQ(bytes.size(), body + 4 * (vertex + 13));
  expect_samples(bytes, body, vertex, 24);
}

TEST_F(WritePly, WritesCloudsWithAndWithoutValues) {
  const auto path = at("t.ply");
  write_ply(path, test::small_cloud(), SampleSite::vertices, values(), colours);
  test::expect_same(read_shape(path), test::small_cloud());
  const std::string bytes = test::bytes_of(path);
  EXPECT_THAT(bytes, Not(HasSubstr("element face")));
  const std::size_t body = bytes.find("end_header\n") + 11;
  constexpr std::size_t point = 6 * 8 + 3 + 8;
  ASSERT_EQ(bytes.size(), body + 4 * point);
  expect_samples(bytes, body, point, 48);
  write_ply(path, test::small_cloud());
  test::expect_same(read_shape(path), test::small_cloud());
}

TEST_F(WritePly, RejectsAWrongNumberOfValuesOrColours) {
  Shape shape = tetrahedron();
  shape.triangles.conservativeResize(3, 3);
  EXPECT_THAT([&] { write_ply(at("t.ply"), shape, SampleSite::faces, values(), colours); },
              ThrowsMessage<InputError>(EndsWith("4 values and 4 colours for 3 samples")));
}

TEST(ReadPly, AcceptsBothPlyNamesOfEachNumberType) {
  const auto coordinate = [](const std::string& type, auto number) {
    std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty " + type +
                        " x\nproperty uchar y\nproperty uchar z\nend_header\n";
    append_little_endian(bytes, number);
    return read_ply(bytes + std::string(2, '\0'), "t.ply").vertices(0, 0);
  };
  const auto extremes = [&](const std::string& type, auto number) {
    using Number = decltype(number);
    for (const Number value : {std::numeric_limits<Number>::lowest(), std::numeric_limits<Number>::max()}) {
      EXPECT_EQ(coordinate(type, value), static_cast<double>(value)) << type;
    }
  };
  for (const char* type : {"char", "int8"}) extremes(type, std::int8_t{});
  for (const char* type : {"uchar", "uint8"}) extremes(type, std::uint8_t{});
  for (const char* type : {"short", "int16"}) extremes(type, std::int16_t{});
  for (const char* type : {"ushort", "uint16"}) extremes(type, std::uint16_t{});
  for (const char* type : {"int", "int32"}) extremes(type, std::int32_t{});
  for (const char* type : {"uint", "uint32"}) extremes(type, std::uint32_t{});
  for (const char* type : {"float", "float32"}) extremes(type, float{});
  for (const char* type : {"double", "float64"}) extremes(type, double{});
}

}  // namespace

}  // namespace shapegauge
