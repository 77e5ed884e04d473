#include "shapegauge/core/io/read_off.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <optional>

#include "shapegauge/core/error.h"
#include "shapegauge/core/io/off_header.h"
#include "shapegauge/core/io/read_off_binary.h"
#include "shapegauge/core/io/reading_errors.h"
#include "shapegauge/core/io/soup_builder.h"
#include "shapegauge/core/io/text_scanner.h"

namespace shapegauge {

namespace {

constexpr std::size_t bytes_of_shortest_vertex = 6;    // "0 0 0\n"
constexpr std::size_t bytes_of_shortest_triangle = 8;  // "3 0 1 2\n"

/// Reads the body of an ASCII OFF file.
class OffBody {
 public:
  OffBody(TextScanner& scanner, const OffHeader& header, OffLayout layout)
      : scanner_(scanner), header_(header), layout_(layout), counts_(read_off_counts(scanner, layout)) {
    // What the file has room for, whatever its header claims.
    soup_.reserve(std::min<std::size_t>(counts_.vertices, scanner.remaining() / bytes_of_shortest_vertex + 1),
                  std::min<std::size_t>(counts_.faces, scanner.remaining() / bytes_of_shortest_triangle + 1));
  }

  Shape read() {
    for (std::int64_t i = 0; i < counts_.vertices; ++i) read_vertex(i);
    for (std::int64_t i = 0; i < counts_.faces; ++i) read_face(i);
    if (layout_ == OffLayout::words && !scanner_.at_end()) scanner_.fail_whole("more data follow the last face");
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

  /// Whether normals follow, the first vertex's position being read. Of interest are those of a point cloud only.
  bool has_normals() {
    return header_.normals && counts_.faces == 0 && (layout_ == OffLayout::words || !scanner_.at_line_end());
  }

  /// The first of the extras.
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

/// The shape, if the file is one whose records do not keep to lines. All its words must fit, so that a truncated file
/// is not taken for such.
std::optional<Shape> read_words(TextScanner scanner, const OffHeader& header) {
  try {
    return OffBody(scanner, header, OffLayout::words).read();
  } catch (const InputError&) {
    return std::nullopt;
  }
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

void check_off_header(const std::string& bytes, const std::string& name) {
  TextScanner scanner(bytes, name);
  if (!read_off_header(scanner).binary) read_off_counts(scanner, OffLayout::lines);
}

}  // namespace shapegauge
