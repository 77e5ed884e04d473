// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "shapegauge/core/io/scanner.h"

namespace shapegauge {

/// Number type of a PLY property, given by the alternative that the variant holds; the value has no meaning.
using PlyType =
    std::variant<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t, std::uint32_t, float, double>;

/// Encoding of the body of a PLY file.
enum class PlyEncoding { ascii, little_endian, big_endian };

/// Property of the elements of a PLY file: a number or a list of numbers.
struct PlyProperty {
  std::string name;
  PlyType type = {};
  bool list = false;
  PlyType count_type = {};  ///< number type of the length of a list; unused unless `list` is true
};

/// Kind of element of a PLY file, such as `vertex` or `face`, with the number of its elements and their properties.
struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;
};

/// Header of a PLY file: the encoding of the body and the kinds of elements in their order.
struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
};

/// Reads a PLY file's header (Greg Turk, "The PLY Polygon File Format") and leaves the scanner at the first byte of the
/// body. Throws InputError, with the line, for an invalid header, and for elements that cannot be read as a shape.
PlyHeader read_ply_header(TextScanner& scanner);

/// Returns the first element of the header called `name`; null if there is none.
const PlyElement* find_ply_element(const PlyHeader& header, std::string_view name);

/// Returns the component of a vertex that a property stores: 0 to 2 for x, y, z; 3 to 5 for nx, ny, nz; 6 for others.
std::size_t ply_place_of(const PlyProperty& property);

/// Returns true if an element has exactly one property for each component of the position (first_place 0) or the normal
/// (first_place 3).
bool has_ply_vector(const PlyElement& element, std::size_t first_place);

/// Returns true if a property is the list of vertex indices of a face or triangle strip.
bool holds_ply_corners(const PlyProperty& property);

}  // namespace shapegauge
