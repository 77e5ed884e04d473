// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <fmt/format.h>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/scanner.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/io/shape_format.h"

namespace shapegauge {

namespace {

bool is_separator(char c) { return c == ',' || c == ';'; }

/// Converts separators to blanks and `//` to `#` for TextScanner. Bytes keep their positions and lines.
std::string in_words(std::string text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (is_separator(text[i])) text[i] = ' ';
    if (text[i] == '/' && i + 1 < text.size() && text[i + 1] == '/') text[i] = '#';
  }
  return text;
}

/// Returns true if numbers on the line have decimal commas: a comma between two digits, in addition to other
/// separators.
bool has_decimal_commas(std::string_view line) {
  const auto is_digit = [&](std::size_t i) { return i < line.size() && line[i] >= '0' && line[i] <= '9'; };
  const auto begins_number = [&](std::size_t i) { return is_digit(i) || (i < line.size() && line[i] == '-'); };
  bool tight_comma = false;
  bool other = false;
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] == ',') tight_comma = tight_comma || (is_digit(i - 1) && is_digit(i + 1));
    const bool separates = line[i] == ';' || line[i] == ' ' || line[i] == '\t';
    other = other || (separates && is_digit(i - 1) && begins_number(i + 1));
  }
  return tight_comma && other;
}

using Triple = std::array<double, 3>;

class XyzReader {
 public:
  /// `text` has converted separators; `original` are the bytes that it was made from.
  XyzReader(const std::string& text, std::string_view original, const std::string& name)
      : scanner_(text, name), original_(original), text_(text) {}

  Shape read() {
    read_count();
    while (!scanner_.at_end()) {
      if (!begin_further_scan()) read_line();
    }
    if (first_column_counts()) scanner_.fail_whole("its first column counts the points; remove that column");
    const std::size_t lines = positions_.size();
    const bool normals_follow = count_ && columns_ == 3 && *count_ > 0 && lines == 2 * *count_;
    if (count_ && lines != *count_ && !normals_follow) fail_count(lines);
    SoupBuilder soup;
    const std::size_t points = normals_follow ? *count_ : lines;
    soup.reserve(points, 0);
    for (std::size_t i = 0; i < points; ++i) soup.add_vertex(positions_[i]);
    for (std::size_t i = points; i < lines; ++i) soup.add_normal(positions_[i]);
    if (normals_in_columns()) {
      for (const Triple& normal : columns_4_to_6_) soup.add_normal(normal);
    }
    return soup.shape();
  }

  /// Reads the number of points or the first line.
  void read_beginning() {
    read_count();
    if (!count_ && !scanner_.at_end()) read_line();
  }

 private:
  /// Reads the names of the columns, or the number of points, if one of them is on the first line.
  void read_count() {
    if (scanner_.at_end()) scanner_.fail_whole("contains only white space and comments");
    if (read_names()) return;
    TextScanner ahead = scanner_;
    ahead.read_word();
    if (ahead.at_line_end()) count_ = read_number_of_points("the number of points, or a point's three coordinates");
  }

  std::size_t read_number_of_points(std::string_view role) {
    std::int64_t count = 0;
    scanner_.read_integer(count, role);
    if (count < 0 || count > std::numeric_limits<std::int32_t>::max()) {
      scanner_.fail(fmt::format("expected 0 to 2147483647 points, found {}", count));
    }
    return static_cast<std::size_t>(count);
  }

  /// Reads a first line that begins with the names x, y and z.
  bool read_names() {
    TextScanner ahead = scanner_;
    std::vector<std::string> names;
    while (!ahead.at_line_end()) names.push_back(lower_case(std::string(ahead.read_word())));
    if (names.size() < 3 || names[0] != "x" || names[1] != "y" || names[2] != "z") return false;
    named_columns_ = names.size();
    other_names_ = names.size() >= 6 && !(names[3] == "nx" && names[4] == "ny" && names[5] == "nz");
    scanner_ = ahead;
    return true;
  }

  /// Reads the number of points of another scan, after those of the first.
  bool begin_further_scan() {
    if (!count_ || positions_.size() != *count_) return false;
    TextScanner ahead = scanner_;
    ahead.read_word();
    if (!ahead.at_line_end()) return false;
    *count_ += read_number_of_points("the number of points of the next scan");
    return true;
  }

  void read_line() {
    const std::size_t begin = text_.size() - scanner_.remaining();
    Triple position;
    for (std::size_t k = 0; k < 3; ++k) {
      if (k > 0 && scanner_.at_line_end()) scanner_.fail(fmt::format("expected 3 coordinates of a point, found {}", k));
      scanner_.read_number(position[k], "a coordinate");
    }
    require_full_cells(begin);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();  // no number
    Triple more = {};
    std::size_t columns = 3;
    for (; !scanner_.at_line_end(); ++columns) {
      const std::string_view word = scanner_.read_word();
      if (columns < 6) more[columns - 3] = parse_number(word).value_or(nan);
    }
    if (positions_.empty()) begin_columns(columns, begin);
    if (columns != columns_) {
      scanner_.fail(fmt::format("expected {1} columns as in the first point, found {0}", columns, columns_));
    }
    if (positions_.size() == std::numeric_limits<std::int32_t>::max())
      scanner_.fail("more than 2147483647 points are not supported");
    positions_.push_back(position);
    if (columns >= 6) add_columns_4_to_6(more);
  }

  /// Refuses a line with an empty cell before its last coordinate, into which later cells would shift. `begin` is the
  /// offset of the first coordinate.
  void require_full_cells(std::size_t begin) const {
    const std::size_t line = original_.substr(0, begin).find_last_of("\r\n") + 1;  // 0 for the first line
    const std::size_t end = text_.size() - scanner_.remaining();
    if (std::ranges::count_if(original_.substr(line, end - line), is_separator) > 2) {
      scanner_.fail("expected 3 coordinates of a point, found an empty cell");
    }
  }

  void begin_columns(std::size_t columns, std::size_t begin) {
    columns_ = columns;
    const std::size_t end = text_.size() - scanner_.remaining();
    if (has_decimal_commas(original_.substr(begin, end - begin))) {
      scanner_.fail("commas and other separators are mixed; write decimal points, not commas");
    }
    if (named_columns_ > 0 && columns > named_columns_) {
      scanner_.fail(
          fmt::format("the first line names {} columns, but the first point has {}: name or remove the others",
                      named_columns_, columns));
    }
  }

  /// Returns true if the first of more than three columns is 0, 1, 2 ... or 1, 2, 3 ..., as of tables with an index.
  [[nodiscard]] bool first_column_counts() const {
    constexpr std::size_t min_points = 10;
    if (columns_ < 4 || positions_.size() < min_points) return false;
    const double first = positions_[0][0];
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      if (positions_[i][0] != first + static_cast<double>(i)) return false;
    }
    return first == 0 || first == 1;
  }

  void add_columns_4_to_6(const Triple& vector) {
    columns_4_to_6_.push_back(vector);
    const Eigen::Vector3d v(vector[0], vector[1], vector[2]);
    const double length = v.stableNorm();
    if (!v.allFinite()) {
      if (!not_finite_) not_finite_ = scanner_.word_offset();
    } else if (length > 0) {
      ++vectors_;
      unit_vectors_ += length > 0.95 && length < 1.05 ? 1 : 0;
      has_negative_ = has_negative_ || v.minCoeff() < 0;
    }
  }

  bool normals_in_columns() {
    if (other_names_ || vectors_ == 0 || 10 * unit_vectors_ < 9 * vectors_ || !has_negative_) return false;
    if (not_finite_) {
      scanner_.fail_at(*not_finite_, "the normal is not three finite numbers; repair or remove the file");
    }
    return true;
  }

  [[noreturn]] void fail_count(std::size_t lines) const {
    if (lines < *count_) {
      scanner_.fail_whole(
          message_truncated(static_cast<std::int64_t>(lines), static_cast<std::int64_t>(*count_), "points"));
    }
    scanner_.fail_whole(fmt::format("found {} points, but the first line announces {}", lines, *count_));
  }

  TextScanner scanner_;
  std::string_view original_;
  std::string_view text_;
  std::optional<std::size_t> count_;
  std::size_t columns_ = 0;
  std::size_t named_columns_ = 0;  ///< 0 without names
  std::vector<Triple> positions_;
  std::vector<Triple> columns_4_to_6_;
  std::size_t vectors_ = 0;                ///< finite, non-zero vectors in columns 4 to 6
  std::size_t unit_vectors_ = 0;           ///< those with a length of about 1
  bool other_names_ = false;               ///< columns 4 to 6 have names that are not nx, ny, nz
  bool has_negative_ = false;              ///< colours, labels and probabilities have no negative component
  std::optional<std::size_t> not_finite_;  ///< offset in the text of the first non-finite normal
};

/// Returns true if the first line is a point. Three integers could also be the counts of an OFF file.
bool begins_like_xyz(std::string_view bytes) {
  const std::string line = in_words(std::string(first_line_of_data(bytes)));
  const std::string name;
  TextScanner scanner(line, name);
  int numbers = 0;
  for (std::string_view word = scanner.read_word(); !word.empty(); word = scanner.read_word()) {
    if (!parse_number(word)) return false;
    ++numbers;
  }
  return numbers > 3 || (numbers == 3 && line.find_first_of(".eE-") != std::string::npos);
}

}  // namespace

Shape read_xyz(const std::string& bytes, const std::string& name) {
  const std::string text = in_words(bytes);
  return XyzReader(text, bytes, name).read();
}

void check_xyz_header(const std::string& bytes, const std::string& name) {
  const std::string text = in_words(bytes);
  XyzReader(text, bytes, name).read_beginning();
}

ShapeFormat xyz_format() {
  static constexpr std::array<std::string_view, 3> extensions{".xyz", ".pwn", ".pts"};
  static constexpr std::array<std::string_view, 2> ambiguous_extensions{".txt", ".csv"};
  return {.name = "XYZ",
          .description = "Lines of numbers: point clouds, with normals or without",
          .extensions = extensions,
          .ambiguous_extensions = ambiguous_extensions,
          .begins_like = begins_like_xyz,
          .check_header = check_xyz_header,
          .read = read_single_file<read_xyz>};
}

}  // namespace shapegauge
