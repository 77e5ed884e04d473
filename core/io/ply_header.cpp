// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/io/ply_header.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <limits>
#include <type_traits>

namespace shapegauge {

namespace {

/// Type by its two names.
struct NamedType {
  std::string_view name;
  std::string_view other_name;
  PlyType type;
};

PlyType read_type(TextScanner& scanner) {
  static constexpr std::array<NamedType, 8> types = {{
      {"char", "int8", std::int8_t{}},
      {"uchar", "uint8", std::uint8_t{}},
      {"short", "int16", std::int16_t{}},
      {"ushort", "uint16", std::uint16_t{}},
      {"int", "int32", std::int32_t{}},
      {"uint", "uint32", std::uint32_t{}},
      {"float", "float32", float{}},
      {"double", "float64", double{}},
  }};
  const std::string_view word = scanner.read_word();
  for (const NamedType& known : types) {
    if (word == known.name || word == known.other_name) return known.type;
  }
  scanner.fail(fmt::format("unknown type \"{}\"; PLY has types such as uchar, int, float and double", word));
}

PlyEncoding read_encoding(TextScanner& scanner) {
  const std::string_view word = scanner.read_word();
  if (word == "ascii") return PlyEncoding::ascii;
  if (word == "binary_little_endian") return PlyEncoding::little_endian;
  if (word == "binary_big_endian") return PlyEncoding::big_endian;
  scanner.fail(fmt::format("unknown format \"{}\"; expected ascii, binary_little_endian or binary_big_endian", word));
}

PlyElement read_element(TextScanner& scanner) {
  PlyElement element;
  element.name = scanner.read_word();
  if (!scanner.read_integer(element.count, "the number of elements")) scanner.fail_whole("ends within its header");
  if (element.count < 0) scanner.fail(fmt::format("the number of elements cannot be {}", element.count));
  return element;
}

bool is_integer(const PlyType& type) {
  return std::visit([](auto number) { return std::is_integral_v<decltype(number)>; }, type);
}

PlyProperty read_property(TextScanner& scanner) {
  PlyProperty property;
  TextScanner ahead = scanner;
  property.list = ahead.read_word() == "list";
  if (property.list) {
    scanner = ahead;
    property.count_type = read_type(scanner);
    if (!is_integer(property.count_type)) scanner.fail("the length of a list must be of an integer type");
  }
  property.type = read_type(scanner);
  property.name = scanner.read_word();
  return property;
}

/// Returns true if the first line of the text ends with CR alone.
bool ends_lines_with_cr(std::string_view text) {
  const std::size_t start = text.find_first_of("\r\n");
  return start != std::string_view::npos && text[start] == '\r' && !text.substr(start).starts_with("\r\n");
}

PlyHeader read_header(TextScanner& scanner) {
  if (scanner.read_word() != "ply") scanner.fail("not a PLY file: it does not begin with \"ply\"");
  const bool cr_alone = ends_lines_with_cr(scanner.rest());
  PlyHeader header;
  bool has_format = false;
  while (true) {
    const std::string_view word = scanner.read_word();
    if (word.empty()) scanner.fail_whole("ends within its header");
    if (word == "end_header") {
      scanner.skip_line();
      break;
    }
    if (word == "format") {
      header.encoding = read_encoding(scanner);
      has_format = true;
    } else if (word == "element") {
      header.elements.push_back(read_element(scanner));
    } else if (word == "property") {
      if (header.elements.empty()) scanner.fail("expected an element before the first property");
      header.elements.back().properties.push_back(read_property(scanner));
    } else if (word != "comment" && word != "obj_info") {
      scanner.fail(
          fmt::format("unknown keyword \"{}\"; expected format, element, property, comment or end_header", word));
    }
    scanner.skip_line();
  }
  if (!has_format) scanner.fail("the header has no line \"format\"");
  // The last line may end otherwise than the first. After CR alone, the body's first byte may look like LF.
  const std::size_t line_end = scanner.rest().starts_with("\r\n") && !cr_alone ? 2 : 1;
  scanner.advance(std::min(line_end, scanner.remaining()));
  return header;
}

void require_vertices(const PlyHeader& header, const TextScanner& scanner) {
  const PlyElement* const vertex = find_ply_element(header, "vertex");
  if (vertex == nullptr) scanner.fail_whole("its header has no element \"vertex\"");
  if (std::ranges::count(header.elements, "vertex", &PlyElement::name) > 1) {
    scanner.fail_whole("its header has two elements \"vertex\"");
  }
  if (vertex->count > std::numeric_limits<std::int32_t>::max()) {
    scanner.fail_whole(
        fmt::format("{} vertices: at most {} can be read", vertex->count, std::numeric_limits<std::int32_t>::max()));
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (std::ranges::count(vertex->properties, axis, ply_component_of) != 1) {
      scanner.fail_whole(fmt::format("its element \"vertex\" needs one property \"{}\"", "xyz"[axis]));
    }
  }
}

void require_readable_faces(const PlyHeader& header, const TextScanner& scanner) {
  for (const std::string name : {"face", "tristrips"}) {
    if (std::ranges::count(header.elements, name, &PlyElement::name) > 1) {
      scanner.fail_whole(fmt::format("its header has two elements \"{}\"", name));
    }
    const PlyElement* const face = find_ply_element(header, name);
    if (face == nullptr || face->count == 0) continue;
    if (face->count > std::numeric_limits<std::int32_t>::max()) {
      scanner.fail_whole(
          fmt::format("{} faces: at most {} can be read", face->count, std::numeric_limits<std::int32_t>::max()));
    }
    const auto corners = std::ranges::find_if(face->properties, is_ply_corner_list);
    if (corners == face->properties.end()) {
      scanner.fail_whole(fmt::format("its element \"{}\" has no list \"vertex_indices\" or \"vertex_index\"", name));
    }
    if (std::any_of(corners + 1, face->properties.end(), is_ply_corner_list)) {
      scanner.fail_whole(fmt::format("its element \"{}\" has two lists of vertices", name));
    }
    if (!is_integer(corners->type)) scanner.fail_whole("the indices of its faces are not of an integer type");
  }
}

}  // namespace

std::size_t ply_component_of(const PlyProperty& property) {
  constexpr std::array<std::string_view, 6> names = {"x", "y", "z", "nx", "ny", "nz"};
  if (property.list) return names.size();
  return static_cast<std::size_t>(std::ranges::find(names, property.name) - names.begin());
}

bool has_ply_vector(const PlyElement& element, std::size_t first_component) {
  return std::ranges::all_of(std::array{0U, 1U, 2U}, [&](std::size_t axis) {
    return std::ranges::count(element.properties, first_component + axis, ply_component_of) == 1;
  });
}

bool is_ply_corner_list(const PlyProperty& property) {
  return property.list && (property.name == "vertex_indices" || property.name == "vertex_index");
}

const PlyElement* find_ply_element(const PlyHeader& header, std::string_view name) {
  const auto found = std::ranges::find(header.elements, name, &PlyElement::name);
  return found == header.elements.end() ? nullptr : &*found;
}

PlyHeader read_ply_header(TextScanner& scanner) {
  PlyHeader header = read_header(scanner);
  require_vertices(header, scanner);
  require_readable_faces(header, scanner);
  return header;
}

}  // namespace shapegauge
