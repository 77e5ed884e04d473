#include "shapegauge/core/io/write_off.h"

#include <array>
#include <charconv>
#include <string>

#include "shapegauge/core/io/atomic_file.h"
#include "shapegauge/core/io/writable_shape.h"

namespace shapegauge {

namespace {

template <typename Number>
void append_number(std::string& text, Number number, char separator) {
  std::array<char, 32> digits;  // the longest double has 24 characters
  char* const end = std::to_chars(digits.data(), digits.data() + digits.size() - 1, number).ptr;
  *end = separator;
  text.append(digits.data(), end + 1);
}

void append_vector(std::string& text, const Eigen::RowVector3d& vector, char end) {
  append_number(text, vector[0], ' ');
  append_number(text, vector[1], ' ');
  append_number(text, vector[2], end);
}

}  // namespace

void write_off(const std::filesystem::path& path, const Shape& shape) {
  require_writable(path, shape);
  const bool with_normals = has_cloud_normals(shape);
  std::string text = with_normals ? "NOFF\n" : "OFF\n";
  append_number(text, shape.vertices.rows(), ' ');
  append_number(text, shape.triangles.rows(), ' ');
  append_number(text, 0, '\n');
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) {
    append_vector(text, shape.vertices.row(i), with_normals ? ' ' : '\n');
    if (with_normals) append_vector(text, shape.normals.row(i), '\n');
  }
  for (const auto& triangle : shape.triangles.rowwise()) {
    text += "3 ";
    append_number(text, triangle[0], ' ');
    append_number(text, triangle[1], ' ');
    append_number(text, triangle[2], '\n');
  }
  write_file_atomically(path, text);
}

}  // namespace shapegauge
