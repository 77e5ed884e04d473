// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <functional>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/little_endian.h"
#include "shapegauge/core/base/single_precision.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/scanner.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/io/shape_format.h"

namespace shapegauge {

namespace {

using Position = std::array<double, 3>;

constexpr std::size_t header_size = 80;
constexpr std::size_t facet_size = 50;

struct PositionHash {
  std::size_t operator()(const Position& position) const {
    std::uint64_t hash = 0;
    for (const double x : position)
      hash = (std::rotl(hash, 23) ^ std::bit_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15U;
    return hash ^ (hash >> 32U);
  }
};

/// Builds a soup with vertices merged by coordinates.
class MergingBuilder {
 public:
  void begin_face() { soup_.begin_face(); }

  void add_corner(Position position) {
    for (double& x : position) x += 0.0;  // -0 becomes 0: they are equal, so they must have the same hash
    const auto [vertex, is_new] = numbers_.try_emplace(position, static_cast<std::int32_t>(soup_.vertices()));
    if (is_new) soup_.add_vertex(position);
    soup_.add_corner(vertex->second);
  }

  [[nodiscard]] Shape shape() { return soup_.shape(); }

 private:
  SoupBuilder soup_;
  std::unordered_map<Position, std::int32_t, PositionHash> numbers_;
};

std::uint32_t number_of_facets(std::string_view bytes) {
  ByteScanner scanner(bytes, std::endian::little);
  std::uint32_t facets = 0;
  scanner.skip(header_size);
  scanner.read(facets);
  return facets;
}

/// Returns true for an ASCII file: it begins with "solid", like many binary files, but has only bytes of text.
bool is_ascii(const std::string& bytes) {
  const std::string_view text = without_byte_order_mark(bytes);
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos || lower_case(std::string(text.substr(start, 5))) != "solid") return false;
  const std::string_view head = std::string_view(bytes).substr(0, 512);
  return head.find('\0') == std::string_view::npos;
}

Shape read_binary(const std::string& bytes, const TextScanner& text) {
  if (bytes.size() < header_size + 4) text.fail_whole("ends within its header of 84 bytes, or is not an STL file");
  const std::uint32_t facets = number_of_facets(bytes);
  ByteScanner scanner(bytes, std::endian::little);
  scanner.skip(header_size + 4);
  MergingBuilder builder;
  for (std::uint32_t i = 0; i < facets; ++i) {
    if (scanner.remaining() < facet_size) text.fail_whole(message_truncated(i, facets, "facets"));
    scanner.skip(12);  // the normal
    builder.begin_face();
    for (int k = 0; k < 3; ++k) {
      std::array<float, 3> corner = {};
      for (float& coordinate : corner) scanner.read(coordinate);
      if (!std::ranges::all_of(corner, [](float x) { return std::isfinite(x); })) {
        text.fail_whole(
            fmt::format("facet {} has a coordinate that is not a finite number; repair or remove the file", i));
      }
      builder.add_corner({corner[0], corner[1], corner[2]});
    }
    scanner.skip(2);  // the attribute
  }
  if (const std::size_t more = scanner.remaining() / facet_size; more > 0) {
    text.fail_whole(
        fmt::format("its header announces {} facets, but {} follow: the number is wrong, or the file is "
                    "several files in one; repair it",
                    facets, facets + more));
  }
  return builder.shape();
}

/// Reads the facets of an ASCII file: a sequence of keywords, independent of lines.
class AsciiReader {
 public:
  explicit AsciiReader(const TextScanner& scanner) : scanner_(scanner) {}

  Shape read() {
    bool in_solid = false;
    while (true) {
      const std::string word = lower_case(std::string(scanner_.read_word()));
      if (word.empty() && !in_solid) break;
      if (word.empty()) scanner_.fail_whole(fmt::format("ends after {} facets, before \"endsolid\"", facets_));
      if (word == "solid" || word == "endsolid") {
        in_solid = word == "solid";
        scanner_.skip_line();  // the solid's name
      } else if (word == "facet" && in_solid) {
        read_facet();
      } else {
        scanner_.fail(fmt::format("expected \"facet\" or \"endsolid\", found \"{}\"", word));
      }
    }
    return builder_.shape();
  }

 private:
  void read_facet() {
    expect("normal");
    if (!scanner_.skip_words(3)) fail_end();
    expect("outer");
    expect("loop");
    builder_.begin_face();
    for (int k = 0; k < 3; ++k) {
      expect("vertex");
      Position position = {};
      for (double& coordinate : position) {
        if (!scanner_.read_number(coordinate, "a coordinate")) fail_end();
      }
      builder_.add_corner(position);
    }
    expect("endloop");
    expect("endfacet");
    ++facets_;
  }

  void expect(std::string_view keyword) {
    const std::string_view word = scanner_.read_word();
    if (word.empty()) fail_end();
    if (lower_case(std::string(word)) != keyword) {
      scanner_.fail(fmt::format("expected \"{}\" in facet {}, found \"{}\"", keyword, facets_, word));
    }
  }

  [[noreturn]] void fail_end() const { scanner_.fail_whole(fmt::format("ends within facet {}", facets_)); }

  TextScanner scanner_;
  MergingBuilder builder_;
  std::int64_t facets_ = 0;
};

/// Vertices in the format's precision.
using FloatPoints = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;

void append_floats(std::string& bytes, const Eigen::RowVector3f& vector) {
  for (const float component : vector) append_little_endian(bytes, component);
}

/// Returns the coordinates of the vertices of triangles, one after another.
std::vector<double> coordinates_of_triangles(const Shape& shape) {
  const std::vector<bool> used = used_vertices(shape);
  std::vector<double> coordinates;
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) {
    if (!used[static_cast<std::size_t>(i)]) continue;
    for (const double coordinate : shape.vertices.row(i)) coordinates.push_back(coordinate);
  }
  return coordinates;
}

/// Returns the largest distance from a vertex to the vertex in single precision.
double distance_to_rounded(std::span<const double> vertices) {
  const Eigen::Map<const Points> exact(vertices.data(), std::ssize(vertices) / 3, 3);
  const Points moved = exact.cast<float>().cast<double>() - exact;
  return moved.rows() == 0 ? 0 : moved.rowwise().norm().maxCoeff();
}

/// Returns true if the file has the size of a binary file with its number of facets.
bool has_size_of_binary(std::string_view bytes) {
  return bytes.size() >= header_size + 4 &&
         bytes.size() == header_size + 4 + facet_size * std::size_t{number_of_facets(bytes)};
}

void check_stl_header(const std::string& bytes, const std::string& name) {
  if (is_ascii(bytes) || bytes.size() >= header_size + 4) return;
  TextScanner(bytes, name).fail_whole("not an STL file: neither \"solid\" nor a header of 84 bytes");
}

}  // namespace

Shape read_stl(const std::string& bytes, const std::string& name) {
  const TextScanner scanner(bytes, name);
  const bool exact = has_size_of_binary(bytes);
  return is_ascii(bytes) && !exact ? AsciiReader(scanner).read() : read_binary(bytes, scanner);
}

void write_stl(const std::filesystem::path& path, const Shape& shape, std::string_view /*comment*/) {
  require_writable(path, shape);
  if (is_cloud(shape)) {
    throw InputError(
        fmt::format("cannot write {}: an STL file holds triangles only, and the shape has none", path.string()));
  }
  const FloatPoints vertices = shape.vertices.cast<float>();
  if (!vertices.allFinite()) {
    throw InputError(
        fmt::format("cannot write {}: a coordinate is too large for the single precision of STL", path.string()));
  }
  std::string bytes = "binary STL by shapegauge";  // must not begin with "solid"
  bytes.resize(header_size, ' ');
  append_little_endian(bytes, static_cast<std::uint32_t>(shape.triangles.rows()));
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    append_floats(bytes, triangle_normal(shape, f).cast<float>());
    for (int corner = 0; corner < 3; ++corner) append_floats(bytes, vertices.row(shape.triangles(f, corner)));
    append_little_endian(bytes, std::uint16_t{0});  // the attribute
  }
  write_file_atomically(path, bytes);
}

std::optional<std::string> precision_warning(const std::filesystem::path& path, const Shape& shape) {
  constexpr double tolerance = 1e-4;  // of the diagonal
  if (shape_writer(path) != write_stl) return std::nullopt;
  const std::vector<double> vertices = coordinates_of_triangles(shape);
  const double moved = distance_to_rounded(vertices);
  const std::size_t merged = rows_merged_in_single_precision(vertices, 3);
  const double part = moved / bounding_box_diagonal(shape);
  if (!(part > tolerance) && merged == 0) return std::nullopt;
  return fmt::format(
      "the single precision of STL moves vertices by up to {:.2g} ({} % of the diagonal){}; centre the shape at the "
      "origin, or write another format, such as .ply",
      moved, two_digits(100 * part),
      merged == 0 ? ""
                  : " and makes " + count_text(static_cast<std::int64_t>(merged), "vertex equal to another",
                                               "vertices equal to others"));
}

ShapeFormat stl_format() {
  static constexpr std::array<std::string_view, 1> extensions{".stl"};
  return {.name = "STL",
          .description = "Stereolithography, ASCII or binary, without indices; written as binary, in single precision",
          .extensions = extensions,
          .begins_like =
              [](std::string_view bytes) {
                return lower_case(std::string(bytes.substr(0, 5))) == "solid" || has_size_of_binary(bytes);
              },
          .check_header = check_stl_header,
          .read = read_single_file<read_stl>,
          .write = write_stl};
}

}  // namespace shapegauge
