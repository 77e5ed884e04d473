#include "shapegauge/core/io/read_off_binary.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <fmt/format.h>

#include "shapegauge/core/io/byte_scanner.h"
#include "shapegauge/core/io/reading_errors.h"
#include "shapegauge/core/io/soup_builder.h"

namespace shapegauge {

namespace {

/// The bytes behind the header's line end.
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

}  // namespace

Shape read_off_binary(const TextScanner& scanner, const OffHeader& header) {
  return BinaryOffBody(scanner, header).read();
}

}  // namespace shapegauge
