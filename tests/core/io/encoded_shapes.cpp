// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/io/encoded_shapes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <limits>

namespace shapegauge::test {

namespace {

template <typename Number>
void append(std::string& bytes, Number number, std::endian order) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if (order != std::endian::native) std::ranges::reverse(raw);
  bytes.append(raw.data(), raw.size());
}

std::string xyz(const Shape& shape, Eigen::Index i) {
  return fmt::format("{} {} {}", shape.vertices(i, 0), shape.vertices(i, 1), shape.vertices(i, 2));
}

std::string ply_header(const Shape& shape, std::string_view format, std::string_view real) {
  return fmt::format(
      "ply\nformat {0} 1.0\ncomment made by hand\nelement vertex {1}\n"
      "property uchar quality\nproperty {2} x\nproperty {2} y\nproperty {2} z\nproperty list uchar short tags\n"
      "element camera 1\nproperty double focus\n"
      "element face {3}\nproperty list uchar uint vertex_indices\nproperty float weight\nend_header\n",
      format, shape.vertices.rows(), real, shape.triangles.rows());
}

}  // namespace

Shape tetrahedron() {
  return {.vertices = Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          .triangles = Triangles{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

std::string as_ascii_off(const Shape& shape) {
  std::string text = fmt::format("OFF\n{} {} 0\n", shape.vertices.rows(), shape.triangles.rows());
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) text += xyz(shape, i) + "\n";
  for (const auto& t : shape.triangles.rowwise()) text += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
  return text;
}

std::string as_binary_off(const Shape& shape, std::string_view header, int extras) {
  std::string bytes(header);
  const auto put = [&](auto number) { append(bytes, number, std::endian::big); };
  for (const Eigen::Index count : {shape.vertices.rows(), shape.triangles.rows(), Eigen::Index{0}}) {
    put(static_cast<std::int32_t>(count));
  }
  for (const auto& vertex : shape.vertices.rowwise()) {
    for (const double x : vertex) put(static_cast<float>(x));
    for (int k = 0; k < extras; ++k) put(0.25F);
  }
  for (const auto& t : shape.triangles.rowwise()) {
    put(std::int32_t{3});
    for (const std::int32_t v : t) put(v);
    put(std::int32_t{1});
    put(0.5F);
  }
  return bytes;
}

std::string as_obj(const Shape& shape) {
  std::string text = "# by hand\no thing\n";
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) text += "v " + xyz(shape, i) + "\n";
  for (const auto& t : shape.triangles.rowwise()) text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return text;
}

std::string as_ascii_ply(const Shape& shape) {
  std::string text = ply_header(shape, "ascii", "double");
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) text += fmt::format("7 {} 2 -1 5\n", xyz(shape, i));
  text += "1.5\n";
  for (const auto& t : shape.triangles.rowwise()) text += fmt::format("3 {} {} {} 0.5\n", t[0], t[1], t[2]);
  return text;
}

std::string as_binary_ply(const Shape& shape, std::endian order, bool doubles) {
  std::string bytes = ply_header(shape, order == std::endian::little ? "binary_little_endian" : "binary_big_endian",
                                 doubles ? "double" : "float");
  const auto put = [&](auto number) { append(bytes, number, order); };
  for (const auto& vertex : shape.vertices.rowwise()) {
    put(std::uint8_t{7});
    for (const double x : vertex) doubles ? put(x) : put(static_cast<float>(x));
    put(std::uint8_t{2});
    put(std::int16_t{-1});
    put(std::int16_t{5});
  }
  put(std::numeric_limits<double>::quiet_NaN());  // ignored by readers of shapes
  for (const auto& t : shape.triangles.rowwise()) {
    put(std::uint8_t{3});
    for (const std::int32_t v : t) put(v);
    put(0.5F);
  }
  return bytes;
}

std::string as_ascii_stl(const Shape& shape) {
  std::string text = "solid by hand\n";
  for (const auto& t : shape.triangles.rowwise()) {
    text += "  facet normal 0 0 0\n    outer loop\n";
    for (const std::int32_t v : t) text += "      vertex " + xyz(shape, v) + "\n";
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid by hand\n";
}

std::string as_binary_stl(const Shape& shape, std::string_view header) {
  std::string bytes(header);
  bytes.resize(80, ' ');
  const auto put = [&](auto number) { append(bytes, number, std::endian::little); };
  put(static_cast<std::uint32_t>(shape.triangles.rows()));
  for (const auto& t : shape.triangles.rowwise()) {
    for (int k = 0; k < 3; ++k) put(0.0F);
    for (const std::int32_t v : t) {
      for (const double x : shape.vertices.row(v)) put(static_cast<float>(x));
    }
    put(std::uint16_t{0});
  }
  return bytes;
}

std::vector<Encoded> encoded_in_every_format(const Shape& shape) {
  const std::string obj = as_obj(shape);
  return {{"ascii.off", as_ascii_off(shape), 1},  // the line end
          {"binary.off", as_binary_off(shape)},
          {"shape.obj", obj, obj.size()},         // OBJ does not record its length
          {"ascii.ply", as_ascii_ply(shape), 3},  // a prefix of the last number, 0.5, is a number too
          {"little_float.ply", as_binary_ply(shape, std::endian::little, false)},
          {"little_double.ply", as_binary_ply(shape, std::endian::little, true)},
          {"big_float.ply", as_binary_ply(shape, std::endian::big, false)},
          {"big_double.ply", as_binary_ply(shape, std::endian::big, true)},
          {"ascii.stl", as_ascii_stl(shape), 9},  // the solid's name
          {"binary.stl", as_binary_stl(shape)},
          {"solid.stl", as_binary_stl(shape, "solid")}};
}

Shape small_cloud() {
  Shape cloud{tetrahedron().vertices, {}, Points(4, 3)};
  cloud.normals << 0, 0, -1, 1, 0, 0, 0, 0, 0, -1, 0, 0;
  return cloud;
}

std::vector<Encoded> cloud_in_every_format(const Shape& cloud) {
  const auto point = [&](Eigen::Index i) { return xyz(cloud, i); };
  const auto normal = [&](Eigen::Index i) { return xyz({cloud.normals, {}}, i); };
  const Eigen::Index n = cloud.vertices.rows();
  std::string lines;
  std::string obj;
  std::string points;
  std::string normals;
  for (Eigen::Index i = 0; i < n; ++i) {
    lines += fmt::format("{} {}\n", point(i), normal(i));
    obj += fmt::format("vn {}\nv {}\n", normal(i), point(i));
    points += point(i) + "\n";
    normals += normal(i) + "\n";
  }
  std::string binary_off = "NOFF BINARY\n";
  for (const Eigen::Index count : {n, Eigen::Index{0}, Eigen::Index{0}}) {
    append(binary_off, static_cast<std::int32_t>(count), std::endian::big);
  }
  const std::string_view format = "ply\nformat {} 1.0\nelement vertex {}\n";
  const std::string properties =
      "property double x\nproperty double y\nproperty double z\nproperty float nx\nproperty float ny\n"
      "property float nz\nend_header\n";
  std::string binary_ply = fmt::format(fmt::runtime(format), "binary_big_endian", n) + properties;
  for (Eigen::Index i = 0; i < n; ++i) {
    for (const double x : cloud.vertices.row(i)) {
      append(binary_off, static_cast<float>(x), std::endian::big);
      append(binary_ply, x, std::endian::big);
    }
    for (const double x : cloud.normals.row(i)) {
      append(binary_off, static_cast<float>(x), std::endian::big);
      append(binary_ply, static_cast<float>(x), std::endian::big);
    }
  }
  const std::string count = fmt::format("{}\n", n);
  const std::string pwn = count + points + normals;
  return {{"lines.xyz", lines, lines.size()},  // XYZ does not record its length
          {"lines.pts", count + lines, 1},     // the line end
          {"halves.pwn", pwn, pwn.size()},     // complete without the normals, too
          {"ascii.off", fmt::format("NOFF\n{} 0 0\n{}", n, lines), 1},
          {"binary.off", binary_off},
          {"cloud.obj", obj, obj.size()},
          {"ascii.ply", fmt::format(fmt::runtime(format), "ascii", n) + properties + lines, 1},
          {"binary.ply", binary_ply}};
}

void expect_same(const Shape& actual, const Shape& expected) {
  ASSERT_EQ(actual.vertices.rows(), expected.vertices.rows());
  ASSERT_EQ(actual.triangles.rows(), expected.triangles.rows());
  EXPECT_EQ(actual.vertices, expected.vertices);
  EXPECT_EQ(actual.triangles, expected.triangles);
  ASSERT_EQ(actual.normals.rows(), expected.normals.rows());
  EXPECT_EQ(actual.normals, expected.normals);
}

}  // namespace shapegauge::test
