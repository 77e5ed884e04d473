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

/// Type of numbers, as one of them.
using PlyType =
    std::variant<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t, std::uint32_t, float, double>;

enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyProperty {
  std::string name;
  PlyType type = {};
  bool list = false;
  PlyType count_type = {};  ///< of a list's length
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
};

/// Reads a PLY file's header (Greg Turk, "The PLY Polygon File Format") and leaves the scanner at the first byte of the
/// body. Throws InputError, with the line, for an invalid header, and for elements that cannot be read as a shape.
PlyHeader read_ply_header(TextScanner& scanner);

/// Returns the element of that name, or null.
const PlyElement* find_ply_element(const PlyHeader& header, std::string_view name);

/// Returns the index of a vertex property: 0 to 2 for coordinates, 3 to 5 for the normal, 6 for any other.
std::size_t ply_place_of(const PlyProperty& property);

/// Returns true if all components of a vector, beginning at an index, have one property each.
bool has_ply_vector(const PlyElement& element, std::size_t first_place);

/// Returns true for a list of the corners of a face or strip.
bool holds_ply_corners(const PlyProperty& property);

}  // namespace shapegauge
