// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/shape/shape.h"

/// Code shared by the readers and writers of shape files; not part of the public interface.
namespace shapegauge {

/// Builds a shape vertex by vertex and corner by corner. Polygons become triangles in order: a fan about the first
/// corner if it covers the polygon, otherwise another triangulation (triangulate_polygon.h). Faces with fewer than
/// three corners produce no triangle. Only point clouds keep their normals, if every vertex has one and not all are
/// zero.
class SoupBuilder {
 public:
  /// Reserves memory for numbers of vertices and triangles.
  void reserve(std::size_t vertices, std::size_t triangles) {
    vertices_.reserve(vertices);
    triangles_.reserve(triangles);
  }

  void add_vertex(const std::array<double, 3>& position) { vertices_.push_back(position); }

  /// Adds the normal, of any length, of the next vertex without one. A zero normal stays zero: scanners write it for
  /// unknown normals.
  void add_normal(const std::array<double, 3>& normal);

  /// Begins a new face, without corners.
  void begin_face() {
    corners_ = 0;
    ++faces_;
  }

  /// Adds a corner to the current face, as a vertex index that the caller has validated; the vertex may follow later.
  void add_corner(std::int32_t vertex) {
    if (++corners_ == 1) first_ = vertex;
    if (corners_ >= 3) add_triangle({first_, previous_, vertex});
    previous_ = vertex;
  }

  /// Returns the number of vertices, or of triangles, added so far.
  [[nodiscard]] std::size_t vertices() const { return vertices_.size(); }
  [[nodiscard]] std::size_t triangles() const { return triangles_.size(); }
  /// Returns the number of corners of the current face.
  [[nodiscard]] std::size_t corners() const { return corners_; }

  /// Returns the shape built so far. The vertices of all corners must have been added.
  [[nodiscard]] Shape shape();

 private:
  void add_triangle(const std::array<std::int32_t, 3>& triangle) {
    if (!is_numbered_ && static_cast<std::size_t>(faces_) != triangles_.size() + 1) number_polygons();
    if (is_numbered_) polygons_.push_back(faces_ - 1);
    triangles_.push_back(triangle);
  }

  void number_polygons();  ///< sets `polygons_` for the triangles added so far: triangle i is face i

  /// Replaces the triangle fans that do not cover their polygons by other triangulations (triangulate_polygon.h).
  void replace_fans();

  /// Returns the triangles that replace the fan of triangles [begin, end); none if the fan covers its polygon.
  [[nodiscard]] std::vector<std::array<std::int32_t, 3>> fan_replacement(std::size_t begin, std::size_t end) const;

  std::vector<std::array<double, 3>> vertices_;         ///< positions of the vertices added so far
  std::vector<std::array<double, 3>> normals_;          ///< normals of the vertices, in their order; may be fewer
  std::vector<std::array<std::int32_t, 3>> triangles_;  ///< vertex indices of the triangles added so far
  std::vector<std::int32_t> polygons_;  ///< per triangle: index of its face; unused while `is_numbered_` is false
  bool is_numbered_ = false;            ///< false while every triangle i is face i
  std::int32_t faces_ = 0;              ///< number of faces begun so far
  std::size_t corners_ = 0;             ///< number of corners of the current face
  std::int32_t first_ = 0;              ///< vertex index of the first corner of the current face
  std::int32_t previous_ = 0;           ///< vertex index of the last corner added
};

/// Returns the first line of a text that is neither blank nor a comment (`#`), trimmed; empty if there is none.
std::string_view first_line_of_data(std::string_view text);

/// Formats the error message for a fault that the readers of all formats report, without the file and line. `face` and
/// `vertex` are indices.
/// @{
/// Message that the file ends after `got` of `expected` items, which are called `what`.
std::string message_truncated(std::int64_t got, std::int64_t expected, std::string_view what);
/// Message that `face` refers to `vertex`, but there are only `vertices` vertices.
std::string message_no_such_vertex(std::int64_t face, std::int64_t vertex, std::int64_t vertices);
/// Message that a `what` (coordinate, normal) of `vertex` is inf or NaN.
std::string message_not_finite(std::int64_t vertex, std::string_view what = "coordinate");
std::string message_no_triangles(std::int64_t faces);     ///< message that none of the `faces` faces has three vertices
std::string message_too_many_corners(std::int64_t face);  ///< message that `face` exceeds max_polygon_corners
/// @}

/// Throws InputError if a shape cannot be written to a readable file: for a coordinate or cloud normal that is not
/// finite, a vertex index out of range, or a wrong number of normals.
void require_writable(const std::filesystem::path& path, const Shape& shape);

/// Returns true for a point cloud with normals, whose normals writers store.
inline bool has_cloud_normals(const Shape& shape) { return is_cloud(shape) && shape.normals.rows() > 0; }

/// Appends a number as text, with the fewest digits that reproduce the same number, and the separator.
template <typename Number>
void append_number(std::string& text, Number number, char separator) {
  std::array<char, 32> digits;  // the longest double has 24 characters
  char* const end = std::to_chars(digits.data(), digits.data() + digits.size() - 1, number).ptr;
  *end = separator;
  text.append(digits.data(), end + 1);
}

/// Appends the three numbers of a vector as text, separated by blanks and followed by `end`.
template <typename Row>
void append_numbers(std::string& text, const Row& row, char end = '\n') {
  append_number(text, row[0], ' ');
  append_number(text, row[1], ' ');
  append_number(text, row[2], end);
}

}  // namespace shapegauge
