// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/shape/shape.h"

/// Contents of shape files, encoded independently of the library's writers.
namespace shapegauge::test {

/// Tetrahedron with vertices at the origin and on the axes.
Shape tetrahedron();

std::string as_ascii_off(const Shape& shape);
/// Binary OFF with `extras` floats after each vertex and a one-component colour after each face.
std::string as_binary_off(const Shape& shape, std::string_view header = "OFF BINARY\n", int extras = 0);
std::string as_obj(const Shape& shape);
std::string as_ascii_ply(const Shape& shape);
/// Binary PLY with float or double coordinates, and with additional properties and an additional element.
std::string as_binary_ply(const Shape& shape, std::endian order, bool doubles);
std::string as_ascii_stl(const Shape& shape);
std::string as_binary_stl(const Shape& shape, std::string_view header = "binary");

struct Encoded {
  std::string file_name;
  std::string bytes;
  std::size_t optional = 0;  ///< number of final bytes whose truncation is undetectable
};

/// The shape in every format and variant.
std::vector<Encoded> encoded_in_every_format(const Shape& shape);

/// Four points with unit normals, one of them zero.
Shape small_cloud();

/// The point cloud in every format and variant with normals.
std::vector<Encoded> cloud_in_every_format(const Shape& cloud);

/// Whether coordinates, indices and normals are equal, in the same order.
void expect_same(const Shape& actual, const Shape& expected);

}  // namespace shapegauge::test
