#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/shape/shape.h"

/// What the readers and writers of shape files share. Not for users of the library.
namespace shapegauge {

/// A shape as it grows vertex by vertex and corner by corner. Polygons become fans of triangles about their first
/// corner, in order; a face with fewer than three corners has no surface and leaves no triangle. Normals stay only with
/// a point cloud, and only where every vertex has one.
class SoupBuilder {
 public:
  void reserve(std::size_t vertices, std::size_t triangles) {
    vertices_.reserve(vertices);
    triangles_.reserve(triangles);
  }

  void add_vertex(const std::array<double, 3>& position) { vertices_.push_back(position); }

  /// Adds the normal of the next vertex that has none; of any length. One of length zero stays zero: scanners write it
  /// where they found none.
  void add_normal(const std::array<double, 3>& normal);

  void begin_face() { corners_ = 0; }

  /// Adds a corner to the face begun last. The caller has checked the index.
  void add_corner(std::int32_t vertex) {
    if (++corners_ == 1) first_ = vertex;
    if (corners_ >= 3) triangles_.push_back({first_, previous_, vertex});
    previous_ = vertex;
  }

  [[nodiscard]] std::size_t vertices() const { return vertices_.size(); }
  [[nodiscard]] std::size_t triangles() const { return triangles_.size(); }
  /// Corners of the face begun last.
  [[nodiscard]] std::size_t corners() const { return corners_; }

  /// The shape so far.
  [[nodiscard]] Shape shape() const;

 private:
  std::vector<std::array<double, 3>> vertices_;
  std::vector<std::array<double, 3>> normals_;
  std::vector<std::array<std::int32_t, 3>> triangles_;
  std::size_t corners_ = 0;
  std::int32_t first_ = 0;
  std::int32_t previous_ = 0;
};

/// What is wrong with a file, in the same words for every format: the part of the message behind file and line.
/// @{
std::string message_truncated(std::int64_t got, std::int64_t expected, std::string_view what);
std::string message_no_such_vertex(std::int64_t face, std::int64_t vertex, std::int64_t vertices);
std::string message_not_finite(std::int64_t vertex, std::string_view what = "coordinate");
std::string message_no_triangles(std::int64_t faces);
/// @}

/// Throws InputError where a file of this shape at `path` could not be read again: a coordinate that is not finite, a
/// triangle with a vertex that does not exist, a cloud's normals that are not finite or not one a point.
void require_writable(const std::filesystem::path& path, const Shape& shape);

/// Whether there are normals to write: those of a point cloud.
inline bool has_cloud_normals(const Shape& shape) { return is_cloud(shape) && shape.normals.rows() > 0; }

/// Appends a number in the fewest digits that give exactly the same number when they are read.
template <typename Number>
void append_number(std::string& text, Number number, char separator) {
  std::array<char, 32> digits;  // the longest double has 24 characters
  char* const end = std::to_chars(digits.data(), digits.data() + digits.size() - 1, number).ptr;
  *end = separator;
  text.append(digits.data(), end + 1);
}

/// Appends the three numbers of a row, with blanks between them.
template <typename Row>
void append_numbers(std::string& text, const Row& row, char end = '\n') {
  append_number(text, row[0], ' ');
  append_number(text, row[1], ' ');
  append_number(text, row[2], end);
}

/// Appends the bytes of a number, least significant first.
template <typename Number>
void append_little_endian(std::string& bytes, Number number) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(raw);
  bytes.append(raw.data(), raw.size());
}

}  // namespace shapegauge
