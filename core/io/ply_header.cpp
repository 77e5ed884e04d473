#include "shapegauge/core/io/ply_header.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <string_view>
#include <utility>

namespace shapegauge {

namespace {

PlyType read_type(TextScanner& scanner) {
  static constexpr std::array<std::pair<std::string_view, PlyType>, 16> names = {{
      {"char", PlyType::int8},
      {"int8", PlyType::int8},
      {"uchar", PlyType::uint8},
      {"uint8", PlyType::uint8},
      {"short", PlyType::int16},
      {"int16", PlyType::int16},
      {"ushort", PlyType::uint16},
      {"uint16", PlyType::uint16},
      {"int", PlyType::int32},
      {"int32", PlyType::int32},
      {"uint", PlyType::uint32},
      {"uint32", PlyType::uint32},
      {"float", PlyType::float32},
      {"float32", PlyType::float32},
      {"double", PlyType::float64},
      {"float64", PlyType::float64},
  }};
  const std::string_view word = scanner.read_word();
  for (const auto& [name, type] : names) {
    if (word == name) return type;
  }
  scanner.fail(fmt::format("\"{}\" is not a type that PLY knows", word));
}

PlyEncoding read_encoding(TextScanner& scanner) {
  const std::string_view word = scanner.read_word();
  if (word == "ascii") return PlyEncoding::ascii;
  if (word == "binary_little_endian") return PlyEncoding::little_endian;
  if (word == "binary_big_endian") return PlyEncoding::big_endian;
  scanner.fail(fmt::format("\"{}\" is not a PLY format", word));
}

PlyElement read_element(TextScanner& scanner) {
  PlyElement element;
  element.name = scanner.read_word();
  if (!scanner.read_integer(element.count, "the number of elements")) scanner.fail_whole("ends within its header");
  if (element.count < 0) scanner.fail(fmt::format("the number of elements cannot be {}", element.count));
  return element;
}

bool is_integer(PlyType type) { return type != PlyType::float32 && type != PlyType::float64; }

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

/// Length of the line end that the text has next: a binary body's first byte may itself look like one.
std::size_t length_of_line_end(std::string_view text) {
  const std::size_t start = text.find_first_of("\r\n");
  return start != std::string_view::npos && text.substr(start).starts_with("\r\n") ? 2 : 1;
}

}  // namespace

PlyHeader read_ply_header(TextScanner& scanner) {
  if (scanner.read_word() != "ply") scanner.fail("not a PLY file: it does not begin with \"ply\"");
  const std::size_t line_end = length_of_line_end(scanner.rest());
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
      if (header.elements.empty()) scanner.fail("a property before the first element");
      header.elements.back().properties.push_back(read_property(scanner));
    } else if (word != "comment" && word != "obj_info") {
      scanner.fail(fmt::format("\"{}\" does not belong in a PLY header", word));
    }
    scanner.skip_line();
  }
  if (!has_format) scanner.fail("the header names no format");
  scanner.advance(std::min(line_end, scanner.remaining()));
  return header;
}

}  // namespace shapegauge
