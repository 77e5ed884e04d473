#pragma once

#include <bit>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/shape/shape.h"

/// Shapes as the bytes of files, written plainly and without the library's writers.
namespace shapegauge::test {

/// Four vertices at the origin and on the axes, four triangles.
Shape tetrahedron();

std::string as_ascii_off(const Shape& shape);
/// With so many floats after each vertex, and a colour of one component after each face.
std::string as_binary_off(const Shape& shape, std::string_view header = "OFF BINARY\n", int extras = 0);
std::string as_obj(const Shape& shape);
std::string as_ascii_ply(const Shape& shape);
/// Coordinates as float, or as double; other properties and an element between those that count.
std::string as_binary_ply(const Shape& shape, std::endian order, bool doubles);
std::string as_ascii_stl(const Shape& shape);
std::string as_binary_stl(const Shape& shape, std::string_view header = "binary");

struct Encoded {
  std::string file_name;
  std::string bytes;
  std::size_t optional = 0;  ///< bytes at the end without which the file cannot be told from a whole one
};

/// The shape in every format and variant.
std::vector<Encoded> encoded_in_every_format(const Shape& shape);

/// Four points with unit normals of which one is zero.
Shape small_cloud();

/// The point cloud with its normals in every format and variant that has them.
std::vector<Encoded> cloud_in_every_format(const Shape& cloud);

/// Coordinates, indices and normals are equal, in order.
void expect_same(const Shape& actual, const Shape& expected);

}  // namespace shapegauge::test
