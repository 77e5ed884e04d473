// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fmt/format.h>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/scanner.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/io/shape_format.h"
#include "shapegauge/core/io/triangulate_polygon.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

namespace {

/// Body format declared by an OFF file's keyword.
struct OffHeader {
  bool binary = false;
  bool texture = false;  ///< ST: 2 numbers after each vertex
  bool colours = false;  ///< C: 4 numbers
  bool normals = false;  ///< N: 3 numbers

  /// Returns the number of values that follow each vertex's coordinates.
  [[nodiscard]] std::size_t vertex_extras() const {
    return (texture ? 2U : 0U) + (colours ? 4U : 0U) + (normals ? 3U : 0U);
  }
};

/// Numbers of vertices and faces in an OFF file.
struct OffCounts {
  std::int64_t vertices = 0;
  std::int64_t faces = 0;
};

/// Separation of records in an ASCII OFF file. `lines`: each record begins a line, and further values on the line are
/// ignored (colours, normals, declared or not). `words`: records follow each other anywhere, as in a file of a single
/// line; the keyword then determines the number of values per vertex.
enum class OffLayout { lines, words };

/// Removes a prefix from the text, if present.
bool consume(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

struct Keyword {
  OffHeader header;
  bool dimensions = false;  // 4OFF, nOFF
  std::size_t length = 0;   // 0: there is none
};

/// [ST][C][N][4][n]OFF, the letters in any order.
Keyword parse_keyword(std::string_view text) {
  Keyword keyword;
  std::string_view rest = text;
  if (consume(rest, "off")) {
    keyword.length = 3;
    return keyword;
  }
  while (!consume(rest, "OFF")) {
    if (consume(rest, "ST")) {
      keyword.header.texture = true;
    } else if (consume(rest, "C")) {
      keyword.header.colours = true;
    } else if (consume(rest, "N")) {
      keyword.header.normals = true;
    } else if (consume(rest, "4") || consume(rest, "n")) {
      keyword.dimensions = true;
    } else {
      return {};
    }
  }
  keyword.length = text.size() - rest.size();
  return keyword;
}

bool ends_keyword(std::string_view rest) {
  return rest.empty() || is_digit(rest.front()) ||
         std::string_view(" \t\r\n#").find(rest.front()) != std::string_view::npos;
}

bool begins_with_keyword(std::string_view text) {
  const std::size_t length = parse_keyword(text).length;
  return length > 0 && ends_keyword(text.substr(length));
}

/// Returns true if the next non-blank line has exactly one word.
bool single_word_on_line(TextScanner scanner) { return !scanner.read_word().empty() && scanner.at_line_end(); }

/// Reads an OFF file's keyword and an optional `BINARY`. A file with a number instead of the keyword is plain OFF.
/// Throws InputError for anything else, and for points that are not three-dimensional (4OFF, nOFF).
OffHeader read_off_header(TextScanner& scanner) {
  if (scanner.at_end()) scanner.fail_whole("contains only white space and comments");
  const Keyword keyword = parse_keyword(scanner.rest());
  const std::string_view behind = scanner.rest().substr(keyword.length);
  if (keyword.length == 0 ? !is_digit(scanner.rest().front()) : !ends_keyword(behind)) {
    scanner.advance(0);
    scanner.fail("not an OFF file: expected the keyword OFF or the number of vertices");
  }
  scanner.advance(keyword.length);
  if (keyword.dimensions)
    scanner.fail("4OFF and nOFF files have points of other than three dimensions; convert it to OFF");
  OffHeader header = keyword.header;
  if (keyword.length > 0 && !scanner.at_line_end() && scanner.rest().starts_with("BINARY")) {
    scanner.read_word();
    header.binary = true;
  }
  return header;
}

/// Throws InputError for a count that is negative or exceeds the range of triangle indices.
void check_off_counts(const OffCounts& counts, const TextScanner& scanner) {
  constexpr std::int64_t largest = std::numeric_limits<std::int32_t>::max();
  if (counts.vertices < 0 || counts.faces < 0) {
    scanner.fail(fmt::format("{} vertices and {} faces: numbers must not be negative", counts.vertices, counts.faces));
  }
  if (counts.vertices > largest || counts.faces > largest) {
    scanner.fail(fmt::format("{} vertices and {} faces: at most {} of each can be read", counts.vertices, counts.faces,
                             largest));
  }
}

/// Reads the line of counts of an ASCII OFF file. Ignores the number of edges, which is often wrong or missing.
OffCounts read_off_counts(TextScanner& scanner, OffLayout layout) {
  OffCounts counts;
  if (!scanner.read_integer(counts.vertices, "the number of vertices") ||
      !scanner.read_integer(counts.faces, "the number of faces")) {
    scanner.fail_whole("ends before the numbers of vertices and faces");
  }
  check_off_counts(counts, scanner);
  if (layout == OffLayout::lines && !scanner.at_line_end()) {
    scanner.skip_line();
  } else if (layout == OffLayout::words || single_word_on_line(scanner)) {
    scanner.skip_words(1);  // the number of edges, perhaps on a line of its own
  }
  return counts;
}

/// Returns the bytes after the header's line end.
std::string_view body_of(std::string_view rest) {
  const std::size_t line_end = rest.find('\n');
  return line_end == std::string_view::npos ? std::string_view() : rest.substr(line_end + 1);
}

class BinaryOffBody {
 public:
  BinaryOffBody(const TextScanner& text, const OffHeader& header)
      : text_(text), header_(header), bytes_(body_of(text.rest()), std::endian::big) {}

  Shape read() {
    read_counts();
    for (std::int64_t i = 0; i < counts_.vertices; ++i) read_vertex(i);
    for (std::int64_t i = 0; i < counts_.faces; ++i) read_face(i);
    if (counts_.faces > 0 && soup_.triangles() == 0) {
      text_.fail_whole(message_no_triangles(counts_.faces));
    }
    return soup_.shape();
  }

 private:
  void read_counts() {
    std::array<std::int32_t, 3> counts;
    for (std::int32_t& count : counts) {
      if (!bytes_.read(count)) text_.fail_whole("ends before the numbers of vertices, faces and edges");
    }
    counts_ = {counts[0], counts[1]};
    check_off_counts(counts_, text_);
    soup_.reserve(std::min<std::size_t>(counts_.vertices, bytes_.remaining() / 12),
                  std::min<std::size_t>(counts_.faces, bytes_.remaining() / 20));
  }

  void read_vertex(std::int64_t i) {
    soup_.add_vertex(read_vector(i, "coordinate"));
    std::size_t extras = header_.vertex_extras();
    if (header_.normals && counts_.faces == 0) {  // those of a mesh are of no interest
      soup_.add_normal(read_vector(i, "normal"));
      extras -= 3;
    }
    if (!bytes_.skip(4 * extras)) fail_end(i, counts_.vertices, "vertices");
  }

  std::array<double, 3> read_vector(std::int64_t vertex, std::string_view what) {
    std::array<double, 3> vector;
    for (double& component : vector) {
      float value = 0;
      if (!bytes_.read(value)) fail_end(vertex, counts_.vertices, "vertices");
      if (!std::isfinite(value)) text_.fail_whole(message_not_finite(vertex, what));
      component = value;
    }
    return vector;
  }

  void read_face(std::int64_t i) {
    std::int32_t corners = 0;
    if (!bytes_.read(corners)) fail_end(i, counts_.faces, "faces");
    if (corners < 0) text_.fail_whole(fmt::format("face {} cannot have {} vertices", i, corners));
    if (static_cast<std::size_t>(corners) > max_polygon_corners) text_.fail_whole(message_too_many_corners(i));
    soup_.begin_face();
    for (std::int32_t k = 0; k < corners; ++k) {
      std::int32_t vertex = 0;
      if (!bytes_.read(vertex)) fail_end(i, counts_.faces, "faces");
      if (vertex < 0 || vertex >= counts_.vertices) {
        text_.fail_whole(message_no_such_vertex(i, vertex, counts_.vertices));
      }
      soup_.add_corner(vertex);
    }
    std::uint32_t colour_components = 0;
    if (!bytes_.read(colour_components) || !bytes_.skip(std::uint64_t{4} * colour_components)) {
      fail_end(i, counts_.faces, "faces");
    }
  }

  [[noreturn]] void fail_end(std::int64_t got, std::int64_t expected, std::string_view what) const {
    text_.fail_whole(message_truncated(got, expected, what));
  }

  const TextScanner& text_;
  OffHeader header_;
  ByteScanner bytes_;
  OffCounts counts_;
  SoupBuilder soup_;
};

/// Reads a shape from the body of a binary OFF file after the header's line: big-endian, 32-bit.
Shape read_off_binary(const TextScanner& scanner, const OffHeader& header) {
  return BinaryOffBody(scanner, header).read();
}

constexpr std::size_t bytes_of_shortest_vertex = 6;    // "0 0 0\n"
constexpr std::size_t bytes_of_shortest_triangle = 8;  // "3 0 1 2\n"

/// Reads the body of an ASCII OFF file.
class OffBody {
 public:
  OffBody(TextScanner& scanner, const OffHeader& header, OffLayout layout)
      : scanner_(scanner), header_(header), layout_(layout), counts_(read_off_counts(scanner, layout)) {
    // Limited by the size of the file, whatever its header announces.
    soup_.reserve(std::min<std::size_t>(counts_.vertices, scanner.remaining() / bytes_of_shortest_vertex + 1),
                  std::min<std::size_t>(counts_.faces, scanner.remaining() / bytes_of_shortest_triangle + 1));
  }

  Shape read() {
    for (std::int64_t i = 0; i < counts_.vertices; ++i) read_vertex(i);
    for (std::int64_t i = 0; i < counts_.faces; ++i) read_face(i);
    if (layout_ == OffLayout::words && !scanner_.at_end()) scanner_.fail_whole("unexpected data after the last face");
    if (face_follows()) {
      scanner_.fail(
          fmt::format("another face after the last of {}: the numbers of vertices and faces are wrong", counts_.faces));
    }
    if (!scanner_.at_end() && begins_with_keyword(scanner_.rest())) {
      scanner_.advance(0);
      scanner_.fail("another OFF file follows; write each shape into a file of its own");
    }
    if (counts_.faces > 0 && soup_.triangles() == 0) {
      scanner_.fail_whole(message_no_triangles(counts_.faces));
    }
    return soup_.shape();
  }

 private:
  void read_vertex(std::int64_t i) {
    std::array<double, 3> position;
    for (double& coordinate : position) {
      if (!scanner_.read_number(coordinate, "a coordinate")) fail_end(i, counts_.vertices, "vertices");
    }
    soup_.add_vertex(position);
    std::size_t extras = header_.vertex_extras();
    if (i == 0) normals_ = has_normals();
    if (normals_) {
      read_normal(i);
      extras -= 3;
    }
    if (layout_ == OffLayout::lines) {
      scanner_.skip_line();
    } else if (!scanner_.skip_words(extras)) {
      fail_end(i, counts_.vertices, "vertices");
    }
  }

  /// Returns true if normals follow the first vertex's position. Only those of point clouds are read.
  bool has_normals() {
    return header_.normals && counts_.faces == 0 && (layout_ == OffLayout::words || !scanner_.at_line_end());
  }

  /// Reads the normal, the first of the extra values.
  void read_normal(std::int64_t i) {
    std::array<double, 3> normal;
    for (double& component : normal) {
      if (layout_ == OffLayout::lines && scanner_.at_line_end()) {
        scanner_.fail(fmt::format("the normal of vertex {} has fewer than three components", i));
      }
      if (!scanner_.read_number(component, "a normal's component")) fail_end(i, counts_.vertices, "vertices");
    }
    soup_.add_normal(normal);
  }

  void read_face(std::int64_t i) {
    std::int64_t corners = 0;
    if (!scanner_.read_integer(corners, "a face's number of vertices")) fail_end(i, counts_.faces, "faces");
    if (corners < (layout_ == OffLayout::words ? 3 : 0)) {
      scanner_.fail(fmt::format("face {} cannot have {} vertices", i, corners));
    }
    if (corners > static_cast<std::int64_t>(max_polygon_corners)) scanner_.fail(message_too_many_corners(i));
    soup_.begin_face();
    for (std::int64_t k = 0; k < corners; ++k) {
      std::int64_t vertex = 0;
      if (!scanner_.read_integer(vertex, "a vertex's index")) fail_end(i, counts_.faces, "faces");
      if (vertex < 0 || vertex >= counts_.vertices) {
        scanner_.fail(message_no_such_vertex(i, vertex, counts_.vertices));
      }
      soup_.add_corner(static_cast<std::int32_t>(vertex));
    }
    if (layout_ == OffLayout::lines) scanner_.skip_line();
  }

  /// Returns true if a line with the indices of a face follows. Other data after the last face is ignored.
  bool face_follows() {
    if (scanner_.at_end()) return false;
    TextScanner ahead = scanner_;
    const auto is_number_below = [&](double limit, double& number) {
      if (ahead.at_line_end()) return false;
      number = parse_number(ahead.read_word()).value_or(-1);
      return number >= 0 && number < limit && number == std::floor(number);
    };
    double corners = 0;
    double vertex = 0;
    if (!is_number_below(static_cast<double>(max_polygon_corners), corners) || corners < 3) return false;
    for (int k = 0; k < static_cast<int>(corners); ++k) {
      if (!is_number_below(static_cast<double>(counts_.vertices), vertex)) return false;
    }
    return true;
  }

  [[noreturn]] void fail_end(std::int64_t got, std::int64_t expected, std::string_view what) const {
    scanner_.fail_whole(message_truncated(got, expected, what));
  }

  TextScanner& scanner_;
  OffHeader header_;
  OffLayout layout_;
  OffCounts counts_;
  bool normals_ = false;
  SoupBuilder soup_;
};

/// Reads a file whose records ignore lines. All words must be consumed; a truncated file is not accepted.
std::optional<Shape> read_words(TextScanner scanner, const OffHeader& header) {
  try {
    return OffBody(scanner, header, OffLayout::words).read();
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Returns true if the first line begins with a keyword.
bool begins_like_off(std::string_view bytes) {
  const std::string_view line = bytes.substr(0, bytes.find_first_of("\r\n"));
  const std::size_t keyword = line.find("OFF");
  constexpr std::string_view may_precede = "\xEF\xBB\xBF \tSTCN4n";
  return keyword != std::string_view::npos &&
         line.substr(0, keyword).find_first_not_of(may_precede) == std::string_view::npos;
}

}  // namespace

Shape read_off(const std::string& bytes, const std::string& name) {
  TextScanner scanner(bytes, name);
  const OffHeader header = read_off_header(scanner);
  if (header.binary) return read_off_binary(scanner, header);
  const TextScanner body = scanner;
  try {
    return OffBody(scanner, header, OffLayout::lines).read();
  } catch (const InputError&) {
    if (std::optional<Shape> shape = read_words(body, header)) return *std::move(shape);
    throw;
  }
}

static void check_off_header(const std::string& bytes, const std::string& name) {
  TextScanner scanner(bytes, name);
  if (!read_off_header(scanner).binary) read_off_counts(scanner, OffLayout::lines);
}

void write_off(const std::filesystem::path& path, const Shape& shape, std::string_view comment) {
  require_writable(path, shape);
  const bool with_normals = has_cloud_normals(shape);
  std::string text = with_normals ? "NOFF\n" : "OFF\n";
  append_number(text, shape.vertices.rows(), ' ');
  append_number(text, shape.triangles.rows(), ' ');
  append_number(text, 0, '\n');
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) {
    append_numbers(text, shape.vertices.row(i), with_normals ? ' ' : '\n');
    if (with_normals) append_numbers(text, shape.normals.row(i));
  }
  for (const auto& triangle : shape.triangles.rowwise()) append_numbers(text += "3 ", triangle);
  if (!comment.empty()) text.append(comment) += '\n';
  write_file_atomically(path, text);
}

ShapeFormat off_format() {
  static constexpr std::array<std::string_view, 1> extensions{".off"};
  return {.name = "OFF",
          .description = "Object File Format, ASCII or binary; written as ASCII",
          .extensions = extensions,
          .begins_like = begins_like_off,
          .check_header = check_off_header,
          .read = read_single_file<read_off>,
          .write = write_off,
          .y_is_up = true};
}

}  // namespace shapegauge
