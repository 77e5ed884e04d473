// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <fmt/format.h>
#include <limits>
#include <string_view>
#include <system_error>

#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/scanner.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/io/shape_format.h"
#include "shapegauge/core/io/triangulate_polygon.h"

namespace shapegauge {

namespace {

/// Returns true for the keyword of a statement, which some programs write in capitals.
bool is_keyword(std::string_view word, std::string_view keyword) {
  const auto lower = [](unsigned char c) { return static_cast<char>(std::tolower(c)); };
  return std::ranges::equal(word, keyword, {}, lower);
}

class ObjReader {
 public:
  explicit ObjReader(const TextScanner& scanner) : scanner_(scanner), beginning_(scanner) {}

  Shape read() {
    while (!scanner_.at_end()) {
      const std::string_view statement = scanner_.read_word();
      if (is_keyword(statement, "v")) {
        read_vertex();
      } else if (is_keyword(statement, "f") || is_keyword(statement, "fo")) {  // the older name
        read_face();
      } else if (statement == "surf" || statement == "curv" || statement == "curv2") {
        free_form_ = true;
      }
      skip_statement();
    }
    const auto vertices = static_cast<std::int64_t>(soup_.vertices());
    if (largest_.vertex >= vertices) {
      scanner_.fail_at(largest_.offset, message_bad_index(largest_.face, largest_.vertex + 1));
    }
    if (vertices == 0) scanner_.fail_whole("no vertices");
    if (faces_ == 0 && free_form_) {
      scanner_.fail_whole("has free-form curves or surfaces but no faces; convert it to a mesh");
    }
    if (faces_ > 0 && soup_.triangles() == 0) scanner_.fail_whole(message_no_triangles(faces_));
    if (faces_ == 0) read_normals();
    return soup_.shape();
  }

 private:
  /// Corner with its position in the text: a face may precede its vertices.
  struct Corner {
    std::int64_t vertex = -1;
    std::int64_t face = 0;
    std::size_t offset = 0;
  };

  /// Returns true at the end of a statement: a backslash at a line's end continues it on the next line.
  bool at_statement_end() {
    while (!scanner_.at_line_end()) {
      if (!is_continuation(scanner_.rest())) return false;
      scanner_.advance(1);
      scanner_.at_end();
    }
    return true;
  }

  static bool is_continuation(std::string_view rest) { return rest.starts_with("\\\n") || rest.starts_with("\\\r"); }

  void skip_statement() {
    while (!at_statement_end()) scanner_.read_word();
  }

  /// Reads the `vn` statements, which are used by point clouds only; whether the file is one is known at the end.
  void read_normals() {
    scanner_ = beginning_;
    for (std::size_t normal = 1; !scanner_.at_end(); skip_statement()) {
      if (!is_keyword(scanner_.read_word(), "vn")) continue;
      soup_.add_normal(read_vector("normal", normal, "a normal's component"));
      ++normal;
    }
  }

  std::array<double, 3> read_vector(std::string_view what, std::size_t number, std::string_view role) {
    std::array<double, 3> vector;
    for (double& component : vector) {
      if (at_statement_end()) scanner_.fail(fmt::format("{} {} has fewer than three coordinates", what, number));
      scanner_.read_number(component, role);
    }
    return vector;
  }

  void read_vertex() {
    const std::array<double, 3> position = read_vector("vertex", soup_.vertices() + 1, "a coordinate");
    if (soup_.vertices() == std::numeric_limits<std::int32_t>::max())
      scanner_.fail("more than 2147483647 vertices are not supported");
    soup_.add_vertex(position);
  }

  void read_face() {
    if (faces_ == std::numeric_limits<std::int32_t>::max())
      scanner_.fail("more than 2147483647 faces are not supported");
    ++faces_;
    soup_.begin_face();
    while (!at_statement_end()) {
      if (soup_.corners() == max_polygon_corners) scanner_.fail(message_too_many_corners(faces_));
      soup_.add_corner(read_corner());
    }
  }

  /// Reads `v`, `v/vt`, `v//vn` or `v/vt/vn`; returns the vertex index from 0.
  std::int32_t read_corner() {
    std::string_view word = scanner_.read_word();
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    std::int64_t index = 0;
    const auto [last, error] = std::from_chars(word.data(), word.data() + word.size(), index);
    if (error != std::errc() || (last != word.data() + word.size() && *last != '/')) {
      scanner_.fail(fmt::format("expected a vertex index, found \"{}\"", word));
    }
    const auto vertices = static_cast<std::int64_t>(soup_.vertices());
    const std::int64_t vertex = index < 0 ? vertices + index : index - 1;
    if (vertex < 0 || vertex > std::numeric_limits<std::int32_t>::max()) {
      scanner_.fail(message_bad_index(faces_, index));
    }
    if (vertex > largest_.vertex) largest_ = {vertex, faces_, scanner_.word_offset()};
    return static_cast<std::int32_t>(vertex);
  }

  [[nodiscard]] std::string message_bad_index(std::int64_t face, std::int64_t index) const {
    return fmt::format("face {} refers to vertex {}, but there are {} vertices, numbered from 1", face, index,
                       soup_.vertices());
  }

  TextScanner scanner_;
  TextScanner beginning_;
  SoupBuilder soup_;
  std::int64_t faces_ = 0;
  bool free_form_ = false;
  Corner largest_;
};

/// Separates the backslashes that continue statements of numbers (v, f and the like) from the numbers before them, and
/// removes blanks behind them. Lines keep their numbers. In other statements, a backslash may end a path.
std::string with_separate_continuations(const std::string& bytes) {
  if (bytes.find('\\') == std::string::npos) return bytes;
  std::string text;
  bool continued = false;
  for (std::size_t begin = 0; begin < bytes.size();) {
    const std::size_t end = std::min(bytes.find_first_of("\r\n", begin), bytes.size());
    const std::string_view line = trim(std::string_view(bytes).substr(begin, end - begin));
    const bool has_numbers = continued || line.find_first_of("vfVF") == 0;
    continued = has_numbers && line.ends_with('\\');
    if (continued) {
      text.append(line.substr(0, line.size() - 1)).append(" \\");
    } else {
      text.append(bytes, begin, end - begin);
    }
    const std::size_t next = std::min(bytes.find_first_not_of("\r\n", end), bytes.size());
    text.append(bytes, end, next - end);
    begin = next;
  }
  return text;
}

/// Returns true if the first statement is one of an OBJ file.
bool begins_like_obj(std::string_view bytes) {
  static constexpr std::array<std::string_view, 12> statements = {"v", "vn", "vt", "vp", "f",      "l",
                                                                  "p", "o",  "g",  "s",  "mtllib", "usemtl"};
  const std::string_view line = first_line_of_data(bytes);
  const std::size_t end = line.find_first_of(" \t");
  return end != std::string_view::npos &&
         std::ranges::count(statements, lower_case(std::string(line.substr(0, end)))) > 0;
}

void check_obj_header(const std::string& bytes, const std::string& name) {
  const std::string text = with_separate_continuations(bytes);
  TextScanner scanner(text, name);
  while (!scanner.at_end()) {
    if (is_keyword(scanner.read_word(), "v")) return;
    scanner.skip_line();
  }
  scanner.fail_whole("not an OBJ file: no vertices");
}

}  // namespace

Shape read_obj(const std::string& bytes, const std::string& name) {
  const std::string text = with_separate_continuations(bytes);
  const TextScanner scanner(text, name);
  const std::size_t zero = text.find('\0');  // would hide the statement behind it
  if (zero != std::string::npos) scanner.fail_at(zero, "a zero byte: the file is damaged");
  return ObjReader(scanner).read();
}

void write_obj(const std::filesystem::path& path, const Shape& shape, std::string_view comment) {
  require_writable(path, shape);
  std::string text;
  for (const auto& vertex : shape.vertices.rowwise()) append_numbers(text += "v ", vertex);
  if (has_cloud_normals(shape)) {
    for (const auto& normal : shape.normals.rowwise()) append_numbers(text += "vn ", normal);
  }
  for (const auto& triangle : shape.triangles.rowwise()) {
    const Eigen::Matrix<std::int64_t, 1, 3> from_one = triangle.cast<std::int64_t>().array() + 1;
    append_numbers(text += "f ", from_one);
  }
  if (!comment.empty()) text.append(comment) += '\n';
  write_file_atomically(path, text);
}

ShapeFormat obj_format() {
  static constexpr std::array<std::string_view, 1> extensions{".obj"};
  return {.name = "OBJ",
          .description = "Wavefront OBJ: vertices, faces, normals of clouds",
          .extensions = extensions,
          .begins_like = begins_like_obj,
          .check_header = check_obj_header,
          .read = read_single_file<read_obj>,
          .write = write_obj,
          .y_is_up = true};
}

}  // namespace shapegauge
