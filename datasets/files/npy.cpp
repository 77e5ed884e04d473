// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/datasets/files/npy.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <system_error>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/little_endian.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/base/utf8.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/scanner.h"
#include "shapegauge/datasets/files/exact_number.h"

namespace shapegauge {

namespace {

constexpr std::string_view magic = "\x93NUMPY";
constexpr std::size_t alignment = 64;  // of the data, as NumPy has it

// Converts a dictionary of Python literals, {'descr': '<f8', 'fortran_order': False, 'shape': (3, 3), }, to JSON.
std::string json_of_literals(std::string_view python) {
  std::string json;
  for (const char c : python) {
    if (c == ')' || c == '}') {
      json.erase(json.find_last_not_of(" \n") + 1);
      if (json.ends_with(',')) json.pop_back();
    }
    switch (c) {
      case 'L':  // of a number, written by Python 2
        break;
      case '\'':
        json += '"';
        break;
      case '(':
        json += '[';
        break;
      case ')':
        json += ']';
        break;
      case 'F':  // of False and True
      case 'T':
        json += static_cast<char>(c - 'A' + 'a');
        break;
      default:
        json += c;
    }
  }
  return json;
}

// Parses the dictionary, which begins at a byte of the file.
NpyHeader parse_dictionary(std::string_view text, std::size_t begin, const std::string& source) {
  const nlohmann::json json = nlohmann::json::parse(json_of_literals(text), nullptr, false);
  const auto has = [&](const char* key, auto is) { return json.contains(key) && is(json.at(key)); };
  if (has("descr", [](const nlohmann::json& type) { return type.is_array(); })) {
    throw InputError(fmt::format("{}: the file holds records; save a plain matrix of float32 or float64", source));
  }
  const auto is_shape = [](const nlohmann::json& shape) {
    return shape.is_array() && std::all_of(shape.begin(), shape.end(),
                                           [](const nlohmann::json& size) { return size.is_number_unsigned(); });
  };
  if (json.size() != 3 || !has("descr", [](const nlohmann::json& type) { return type.is_string(); }) ||
      !has("fortran_order", [](const nlohmann::json& order) { return order.is_boolean(); }) ||
      !has("shape", is_shape)) {
    throw InputError(fmt::format(
        "{}: byte {}: the header must be a dictionary of 'descr', 'fortran_order' and 'shape', as numpy.save writes it",
        source, begin));
  }
  return {.type = json.at("descr").get<std::string>(),
          .column_by_column = json.at("fortran_order").get<bool>(),
          .shape = json.at("shape").get<std::vector<std::uint64_t>>()};
}

}  // namespace

NpyHeader parse_npy_header(std::string_view bytes, const std::string& source) {
  if (!bytes.starts_with(magic)) {
    throw InputError(source + ": this is no .npy file, which begins with the byte 147 and \"NUMPY\"");
  }
  ByteScanner scanner(bytes.substr(magic.size()), std::endian::little);
  std::uint8_t major = 0;
  std::uint8_t minor = 0;
  std::uint32_t length = 0;
  std::uint16_t short_length = 0;
  bool complete = scanner.read(major) && scanner.read(minor);
  if (complete && (major < 1 || major > 3)) {
    throw InputError(fmt::format("{}: version {}.{} of .npy is not supported, only 1 to 3", source, major, minor));
  }
  if (complete && major == 1) {
    complete = scanner.read(short_length);
    length = short_length;
  } else if (complete) {
    complete = scanner.read(length);
  }
  if (!complete || scanner.remaining() < length) {
    throw InputError(fmt::format("{}: the file ends after {} bytes, within its header", source, bytes.size()));
  }
  const std::size_t begin = bytes.size() - scanner.remaining();
  NpyHeader header = parse_dictionary(bytes.substr(begin, length), begin, source);
  header.data_begin = begin + length;
  return header;
}

namespace {

std::string header_of_shape(const std::string& shape) {
  std::string dictionary = fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}), }}", shape);
  const std::size_t fixed = magic.size() + 2 + sizeof(std::uint16_t);
  while ((fixed + dictionary.size() + 1) % alignment != 0) dictionary += ' ';
  dictionary += '\n';
  std::string header(magic);
  header.append({'\x01', '\x00'});
  append_little_endian(header, static_cast<std::uint16_t>(dictionary.size()));
  return header + dictionary;
}

}  // namespace

std::string npy_header_of_matrix(std::size_t rows, std::size_t columns) {
  return header_of_shape(fmt::format("{}, {}", rows, columns));
}

std::string npy_header_of_vector(std::size_t size) { return header_of_shape(fmt::format("{},", size)); }

namespace {

std::string shape_as_text(const NpyHeader& header) {
  return fmt::format("({})", printable(fmt::format("{}", fmt::join(header.shape, ", ")), 60));
}

template <typename Number, std::endian order>
void decode(const char* bytes, std::size_t count, double* numbers) {
  for (std::size_t i = 0; i < count; ++i) {
    std::array<char, sizeof(Number)> raw;
    std::memcpy(raw.data(), bytes + i * sizeof(Number), sizeof(Number));
    if constexpr (order != std::endian::native) std::ranges::reverse(raw);
    numbers[i] = exact_number(std::bit_cast<Number>(raw));
  }
}

template <typename Number>
NumberFormat format_in(std::endian order) {
  return {.bytes = sizeof(Number),
          .decode = order == std::endian::big ? decode<Number, std::endian::big> : decode<Number, std::endian::little>};
}

// IEEE 754 binary16.
struct Half {
  std::uint16_t bits = 0;

  explicit operator double() const {
    const int exponent = (bits >> 10) & 0x1F;
    const int fraction = bits & 0x3FF;
    const double sign = (bits >> 15) != 0 ? -1.0 : 1.0;
    if (exponent == 0x1F) {
      return fraction == 0 ? sign * std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
    }
    return sign * (exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(fraction + 0x400, exponent - 25));
  }
};

NumberFormat number_format_of(const NpyHeader& header, const std::string& source) {
  struct Kind {
    std::string_view name;
    NumberFormat (*format)(std::endian);
  };
  static constexpr std::array kinds = {
      Kind{"f8", format_in<double>},        Kind{"f4", format_in<float>},         Kind{"f2", format_in<Half>},
      Kind{"i1", format_in<std::int8_t>},   Kind{"i2", format_in<std::int16_t>},  Kind{"i4", format_in<std::int32_t>},
      Kind{"i8", format_in<std::int64_t>},  Kind{"u1", format_in<std::uint8_t>},  Kind{"u2", format_in<std::uint16_t>},
      Kind{"u4", format_in<std::uint32_t>}, Kind{"u8", format_in<std::uint64_t>}, Kind{"b1", format_in<std::uint8_t>},
  };
  const std::string_view type = header.type;
  const auto* const kind = std::ranges::find(kinds, type.substr(std::min<std::size_t>(1, type.size())), &Kind::name);
  const bool known_order = type.find_first_of("<>|=") == 0;
  if (known_order && kind != kinds.end()) {
    return kind->format(type.starts_with('>')   ? std::endian::big
                        : type.starts_with('=') ? std::endian::native
                                                : std::endian::little);
  }
  if (type.ends_with('O')) {
    throw InputError(
        fmt::format("{}: arrays of Python objects are not supported; save numbers as float64, and labels as "
                    "numpy.array(labels, dtype=str)",
                    source));
  }
  throw InputError(
      fmt::format("{}: numbers of type {} are not supported; save the array as float64", source, quoted_word(type)));
}

void check_shape(const NpyHeader& header, TableShape expected, const std::string& source) {
  const std::vector<std::uint64_t>& shape = header.shape;
  if (expected == TableShape::square && (shape.size() != 2 || shape[0] != shape[1] || shape[0] == 0)) {
    throw InputError(fmt::format("{}: expected a square distance matrix, found an array of shape {}", source,
                                 shape_as_text(header)));
  }
  const bool table = shape.size() == 1 || shape.size() == 2;
  if (!table || std::ranges::find(shape, std::uint64_t{0}) != shape.end()) {
    throw InputError(
        fmt::format("{}: expected a matrix of numbers, found an array of shape {}", source, shape_as_text(header)));
  }
}

std::uint64_t columns_of(const NpyHeader& header) { return header.shape.size() == 1 ? 1 : header.shape[1]; }

void check_data_size(const NpyHeader& header, std::size_t item, std::size_t file_size, const std::string& source) {
  const std::size_t data_bytes = file_size - header.data_begin;
  const std::uint64_t rows = header.shape[0];
  const std::uint64_t columns = columns_of(header);
  // Compared by division: the product of an announced size could overflow.
  if (rows <= data_bytes / item / columns && rows * columns * item == data_bytes) return;
  throw InputError(fmt::format(
      "{}: {} bytes of data do not match an array of shape {} and type {}; the file is truncated or damaged", source,
      data_bytes, shape_as_text(header), printable(header.type, 40)));
}

/// Layout of the strings of an array in its file.
struct StringFormat {
  bool unicode = false;  ///< a character has four bytes, not one
  std::endian order = std::endian::little;
  std::size_t length = 0;  ///< in characters; shorter ones are followed by zeros
};

/// Returns nothing for a type other than strings.
std::optional<StringFormat> string_format_of(std::string_view type) {
  if (type.size() < 3 || std::string_view("<>|=").find(type[0]) == std::string_view::npos) return std::nullopt;
  if (type[1] != 'U' && type[1] != 'S') return std::nullopt;
  StringFormat format{
      .unicode = type[1] == 'U',
      .order = type[0] == '>' ? std::endian::big : (type[0] == '=' ? std::endian::native : std::endian::little)};
  const char* const end = type.data() + type.size();
  const auto [stop, error] = std::from_chars(type.data() + 2, end, format.length);
  constexpr std::size_t longest = 1 << 20;
  if (error != std::errc() || stop != end || format.length == 0 || format.length > longest) return std::nullopt;
  return format;
}

/// Decodes one string of `format.length` characters, without trailing zeros; nothing for invalid Unicode.
std::optional<std::string> decoded_string(std::string_view bytes, const StringFormat& format) {
  if (!format.unicode) return std::string(bytes.substr(0, bytes.find_last_not_of('\0') + 1));
  std::u32string characters;
  ByteScanner scanner(bytes, format.order);
  for (std::uint32_t character = 0; scanner.read(character);) {
    if (character > 0x10FFFF || (character >= 0xD800 && character < 0xE000)) return std::nullopt;
    characters += static_cast<char32_t>(character);
  }
  characters.erase(characters.find_last_not_of(U'\0') + 1);
  std::string text;
  for (const char32_t character : characters) append_utf8(text, character);
  return text;
}

DistanceMatrix decoded(std::string_view bytes, const NpyTable& table, const std::string& source) {
  const bool turned = table.column_by_column;
  DistanceMatrix matrix(turned ? table.columns : table.rows, turned ? table.rows : table.columns);
  with_source(source, [&] {
    table.numbers.decode(bytes.data() + table.data_begin, static_cast<std::size_t>(matrix.size()), matrix.data());
  });
  if (turned) matrix.transposeInPlace();
  return matrix;
}

}  // namespace

NumberFormat float32_format() { return format_in<float>(std::endian::little); }

NpyTable parse_npy_table_header(std::string_view beginning, std::size_t file_size, TableShape shape,
                                const std::string& source) {
  const NpyHeader header = parse_npy_header(beginning, source);
  check_shape(header, shape, source);
  const NumberFormat numbers = number_format_of(header, source);
  check_data_size(header, numbers.bytes, file_size, source);
  return {.rows = static_cast<Eigen::Index>(header.shape[0]),
          .columns = static_cast<Eigen::Index>(columns_of(header)),
          .numbers = numbers,
          .column_by_column = header.column_by_column,
          .data_begin = header.data_begin};
}

DistanceMatrix parse_npy(std::string_view bytes, const std::string& source, TableShape shape) {
  return decoded(bytes, parse_npy_table_header(bytes, bytes.size(), shape, source), source);
}

std::optional<std::vector<std::string>> parse_npy_strings(std::string_view bytes, const std::string& source) {
  const NpyHeader header = parse_npy_header(bytes, source);
  const std::optional<StringFormat> format = string_format_of(header.type);
  if (!format) return std::nullopt;
  check_shape(header, TableShape::any, source);
  if (header.shape[0] != 1 && columns_of(header) != 1) {
    throw InputError(fmt::format("{}: expected a one-dimensional array of strings, found the shape {}", source,
                                 shape_as_text(header)));
  }
  const std::size_t item = format->length * (format->unicode ? 4 : 1);
  check_data_size(header, item, bytes.size(), source);
  std::vector<std::string> strings;
  for (std::size_t begin = header.data_begin; begin < bytes.size(); begin += item) {
    std::optional<std::string> string = decoded_string(bytes.substr(begin, item), *format);
    if (!string) {
      throw InputError(fmt::format("{}: entry {} (counted from 0) is not valid Unicode; the file is damaged", source,
                                   strings.size()));
    }
    strings.push_back(*std::move(string));
  }
  return strings;
}

std::string npy_numbers(std::span<const double> numbers) {
  std::string bytes;
  bytes.reserve(numbers.size_bytes());
  for (const double number : numbers) append_little_endian(bytes, number);
  return bytes;
}

namespace {

void write_numbers(const std::filesystem::path& path, std::string header, std::span<const double> numbers) {
  write_file_atomically(path, header.append(npy_numbers(numbers)));
}

}  // namespace

void write_npy(const std::filesystem::path& path, const DistanceMatrix& matrix) {
  write_numbers(path,
                npy_header_of_matrix(static_cast<std::size_t>(matrix.rows()), static_cast<std::size_t>(matrix.cols())),
                {matrix.data(), static_cast<std::size_t>(matrix.size())});
}

void write_npy_vector(const std::filesystem::path& path, const Eigen::VectorXd& values) {
  const auto size = static_cast<std::size_t>(values.size());
  write_numbers(path, npy_header_of_vector(size), {values.data(), size});
}

}  // namespace shapegauge
