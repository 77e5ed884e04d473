#include "shapegauge/core/io/reading_errors.h"

#include <fmt/format.h>

namespace shapegauge {

std::string message_truncated(std::int64_t got, std::int64_t expected, std::string_view what) {
  return fmt::format("ends after {} of {} {}; the file is truncated or its header is wrong", got, expected, what);
}

std::string message_no_such_vertex(std::int64_t face, std::int64_t vertex, std::int64_t vertices) {
  return fmt::format("face {} refers to vertex {}, but the vertices are numbered 0 to {}", face, vertex, vertices - 1);
}

std::string message_not_finite(std::int64_t vertex, std::string_view what) {
  return fmt::format("vertex {} has a {} that is not a finite number; repair or remove the file", vertex, what);
}

std::string message_no_triangles(std::int64_t faces) {
  return fmt::format("none of its {} faces has three vertices", faces);
}

}  // namespace shapegauge
