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
  std::string name;         ///< name of the property, such as "x" or "vertex_indices"
  PlyType type = {};        ///< number type of the value, or of the values of a list
  bool list = false;        ///< true for a list of numbers, such as the vertex indices of a face
  PlyType count_type = {};  ///< number type of the length of a list; unused unless `list` is true
};

/// Kind of element of a PLY file, such as `vertex` or `face`, with the number of its elements and their properties.
struct PlyElement {
  std::string name;                     ///< name of the kind, such as "vertex"
  std::int64_t count = 0;               ///< number of elements of this kind in the file
  std::vector<PlyProperty> properties;  ///< properties of each element, in the order of the file
};

/// Header of a PLY file: the encoding of the body and the kinds of elements in their order.
struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;  ///< encoding of the body
  std::vector<PlyElement> elements;           ///< kinds of elements, in the order of their data in the body
};

/// Reads a PLY file's header (Greg Turk, "The PLY Polygon File Format") and leaves the scanner at the first byte of the
/// body. Throws InputError, with the line, for an invalid header, and for elements that cannot be read as a shape.
PlyHeader read_ply_header(TextScanner& scanner);

/// Returns the first element of the header called `name`; null if there is none.
const PlyElement* find_ply_element(const PlyHeader& header, std::string_view name);

/// Returns the index of the vertex component that a property stores: 0 to 2 for the position x, y, z; 3 to 5 for the
/// normal nx, ny, nz; 6 for any other property.
std::size_t ply_component_of(const PlyProperty& property);

/// Returns true if an element has exactly one property for each component of the position (first_component 0) or the
/// normal (first_component 3).
bool has_ply_vector(const PlyElement& element, std::size_t first_component);

/// Returns true if a property is the list of vertex indices of a face or triangle strip.
bool is_ply_corner_list(const PlyProperty& property);

}  // namespace shapegauge
