#pragma once

#include <cstddef>
#include <cstdint>

#include "shapegauge/core/io/text_scanner.h"

namespace shapegauge {

/// What an OFF file's keyword says of its body.
struct OffHeader {
  bool binary = false;
  bool texture = false;  ///< ST: 2 numbers after each vertex
  bool colours = false;  ///< C: 4 numbers
  bool normals = false;  ///< N: 3 numbers

  /// Numbers that follow each vertex's coordinates.
  [[nodiscard]] std::size_t vertex_extras() const {
    return (texture ? 2U : 0U) + (colours ? 4U : 0U) + (normals ? 3U : 0U);
  }
};

/// Numbers of vertices and faces in an OFF file.
struct OffCounts {
  std::int64_t vertices = 0;
  std::int64_t faces = 0;
};

/// How the records of an ASCII OFF file are told apart. `lines`: each begins a line, and what follows it on the line is
/// of no interest (colours, normals, with or without a keyword that announces them). `words`: they follow each other
/// anyhow, as in a file that is a single line; then the keyword says how many numbers belong to a vertex.
enum class OffLayout { lines, words };

/// Reads an OFF file's keyword, and `BINARY` behind it. A file without a keyword, but with a number in its place, is
/// plain OFF. Throws InputError where it is something else, or where the points are not three-dimensional (4OFF, nOFF).
OffHeader read_off_header(TextScanner& scanner);

/// Reads the line of counts of an ASCII OFF file. The number of edges, which is often wrong or missing, is passed over.
OffCounts read_off_counts(TextScanner& scanner, OffLayout layout);

/// Throws InputError where a count is negative or more than a triangle's indices can address.
void check_off_counts(const OffCounts& counts, const TextScanner& scanner);

}  // namespace shapegauge
