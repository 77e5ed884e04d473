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

}  // namespace

void write_off(const std::filesystem::path& path, const Shape& shape) {
  require_writable(path, shape);
  std::string text = "OFF\n";
  append_number(text, shape.vertices.rows(), ' ');
  append_number(text, shape.triangles.rows(), ' ');
  append_number(text, 0, '\n');
  for (const auto& vertex : shape.vertices.rowwise()) {
    append_number(text, vertex[0], ' ');
    append_number(text, vertex[1], ' ');
    append_number(text, vertex[2], '\n');
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
