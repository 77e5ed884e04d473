// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fmt/format.h>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/little_endian.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/ply_header.h"
#include "shapegauge/core/io/scanner.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/io/shape_format.h"
#include "shapegauge/core/io/triangulate_polygon.h"

namespace shapegauge {

namespace {

/// Returns true for no bytes, zeros and line ends.
bool is_padding(std::string_view bytes) {
  return bytes.find_first_not_of(std::string_view("\0\r\n", 3)) == std::string_view::npos;
}

/// Sequential values of an ASCII PLY file's body. Every reading function returns false at the end.
class PlyTextSource {
 public:
  explicit PlyTextSource(const TextScanner& body) : body_(body) {}

  bool read_real(double& value, PlyType /*type*/) { return body_.read_number(value, "a coordinate"); }
  bool read_whole(std::int64_t& value, PlyType /*type*/) { return body_.read_integer(value, "an index or a length"); }
  bool skip(PlyType /*type*/, std::uint64_t count) { return body_.skip_words(count); }
  bool at_end() { return body_.at_end() || is_padding(body_.rest()); }
  [[nodiscard]] std::size_t remaining() const { return body_.remaining(); }
  /// Throws InputError for the last value read.
  [[noreturn]] void fail(std::string_view message) const { body_.fail(message); }

 private:
  TextScanner body_;
};

/// Sequential values of a binary body.
class PlyBinarySource {
 public:
  PlyBinarySource(const TextScanner& body, std::endian order) : text_(body), bytes_(body.rest(), order) {}

  bool read_real(double& value, PlyType type) { return read_as(value, type); }
  bool read_whole(std::int64_t& value, PlyType type) { return read_as(value, type); }
  bool skip(PlyType type, std::uint64_t count) {
    return std::visit([&](auto example) { return bytes_.skip(sizeof(example) * count); }, type);
  }
  [[nodiscard]] bool at_end() const { return is_padding(text_.rest().substr(text_.remaining() - bytes_.remaining())); }
  [[nodiscard]] std::size_t remaining() const { return bytes_.remaining(); }
  [[noreturn]] void fail(std::string_view message) const { text_.fail_whole(message); }

 private:
  template <typename Value>
  bool read_as(Value& value, PlyType type) {
    return std::visit(
        [&](auto number) {
          if (!bytes_.read(number)) return false;
          value = static_cast<Value>(+number);
          return true;
        },
        type);
  }

  TextScanner text_;
  ByteScanner bytes_;
};

/// Reads the body of a PLY file from a PlyTextSource or a PlyBinarySource.
template <typename Source>
class PlyBody {
 public:
  PlyBody(const PlyHeader& header, Source source)
      : header_(header), source_(std::move(source)), vertices_(find_ply_element(header, "vertex")->count) {
    // Limited by the size of the file, whatever its header announces: a coordinate takes at least a byte and a
    // separator.
    const PlyElement* const face = find_ply_element(header, "face");
    const PlyElement& vertex = *find_ply_element(header, "vertex");
    // The normals of a mesh are ignored.
    numbers_read_ = (face == nullptr || face->count == 0) && has_ply_vector(vertex, 3) ? 6 : 3;
    std::ranges::transform(vertex.properties, std::back_inserter(vertex_numbers_), ply_component_of);
    soup_.reserve(std::min<std::size_t>(vertices_, source_.remaining() / 3),
                  std::min<std::size_t>(face == nullptr ? 0 : face->count, source_.remaining() / 4));
  }

  Shape read() {
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;
      for (std::int64_t i = 0; i < element.count; ++i) {
        if (!read_item(element, i)) source_.fail(message_truncated(i, element.count, name_of_items(element)));
      }
      if ((element.name == "face" || element.name == "tristrips") && element.count > 0 && soup_.triangles() == 0) {
        source_.fail(message_no_triangles(element.count));
      }
    }
    if (!source_.at_end()) {
      source_.fail("more data follow its last element: the numbers of items or the properties in the header are wrong");
    }
    return soup_.shape();
  }

 private:
  static std::string name_of_items(const PlyElement& element) {
    if (element.name == "vertex") return "vertices";
    if (element.name == "face") return "faces";
    return fmt::format("items of its element \"{}\"", element.name);
  }

  bool read_item(const PlyElement& element, std::int64_t i) {
    if (element.name == "vertex") return read_vertex(element, i);
    return std::ranges::all_of(element.properties, [&](const PlyProperty& property) {
      if (!is_ply_corner_list(property)) return skip(property);
      if (element.name == "tristrips") return read_strips(property, i);
      return element.name == "face" ? read_corners(property, i) : skip(property);
    });
  }

  bool read_vertex(const PlyElement& element, std::int64_t i) {
    std::array<double, 6> numbers = {};  // the position and the normal
    for (std::size_t k = 0; k < vertex_numbers_.size(); ++k) {
      const PlyProperty& property = element.properties[k];
      const std::size_t component = vertex_numbers_[k];
      if (component >= numbers_read_ ? !skip(property) : !source_.read_real(numbers[component], property.type))
        return false;
    }
    const auto [x, y, z, nx, ny, nz] = numbers;
    if (!is_finite({x, y, z})) source_.fail(message_not_finite(i));
    soup_.add_vertex({x, y, z});
    if (numbers_read_ == 6) {
      if (!is_finite({nx, ny, nz})) source_.fail(message_not_finite(i, "normal"));
      soup_.add_normal({nx, ny, nz});
    }
    return true;
  }

  static bool is_finite(const std::array<double, 3>& vector) {
    return std::ranges::all_of(vector, [](double x) { return std::isfinite(x); });
  }

  bool read_corners(const PlyProperty& property, std::int64_t i) {
    std::int64_t corners = 0;
    if (!source_.read_whole(corners, property.count_type)) return false;
    if (corners < 0) source_.fail(fmt::format("face {} cannot have {} vertices", i, corners));
    if (corners > static_cast<std::int64_t>(max_polygon_corners)) source_.fail(message_too_many_corners(i));
    soup_.begin_face();
    for (std::int64_t k = 0; k < corners; ++k) {
      std::int64_t vertex = 0;
      if (!source_.read_whole(vertex, property.type)) return false;
      if (vertex < 0 || vertex >= vertices_) source_.fail(message_no_such_vertex(i, vertex, vertices_));
      soup_.add_corner(static_cast<std::int32_t>(vertex));
    }
    return true;
  }

  /// Reads a list of triangle strips, which -1 separates. Each corner after two others makes a triangle; every second
  /// one is turned round.
  bool read_strips(const PlyProperty& property, std::int64_t i) {
    std::int64_t length = 0;
    if (!source_.read_whole(length, property.count_type)) return false;
    if (length < 0) source_.fail(fmt::format("strip {} cannot have {} vertices", i, length));
    std::array<std::int32_t, 3> corners = {};
    for (std::int64_t k = 0, in_strip = 0; k < length; ++k) {
      std::int64_t vertex = 0;
      if (!source_.read_whole(vertex, property.type)) return false;
      if (vertex < -1 || vertex >= vertices_) source_.fail(message_no_such_vertex(i, vertex, vertices_));
      if (vertex == -1) {
        in_strip = 0;
        continue;
      }
      corners = {corners[1], corners[2], static_cast<std::int32_t>(vertex)};
      if (++in_strip >= 3) add_triangle_of_strip(corners, in_strip % 2 == 0);
    }
    return true;
  }

  /// Adds a triangle; one with a repeated corner only continues the strip elsewhere.
  void add_triangle_of_strip(const std::array<std::int32_t, 3>& corners, bool turned) {
    const auto [a, b, c] = corners;
    if (a == b || b == c || c == a) return;
    soup_.begin_face();
    for (const std::int32_t corner : {turned ? b : a, turned ? a : b, c}) soup_.add_corner(corner);
  }

  bool skip(const PlyProperty& property) {
    std::int64_t length = 1;
    if (property.list && !source_.read_whole(length, property.count_type)) return false;
    if (length < 0) source_.fail(fmt::format("the list \"{}\" cannot have {} items", property.name, length));
    return source_.skip(property.type, static_cast<std::uint64_t>(length));
  }

  const PlyHeader& header_;
  Source source_;
  std::int64_t vertices_;
  std::vector<std::size_t> vertex_numbers_;  ///< ply_component_of() of the vertices' properties
  std::size_t numbers_read_ = 3;             ///< lower ones are read, the others skipped
  SoupBuilder soup_;
};

/// Properties of samples at a site.
struct SampleProperties {
  SampleSite site;
  std::string declaration;
  std::function<void(std::string& bytes, Eigen::Index sample)> append;
  std::string comment = {};
};

constexpr std::string_view normal_declaration = "property double nx\nproperty double ny\nproperty double nz\n";

std::string header_of(const Shape& shape, const SampleProperties* samples) {
  const auto properties_at = [&](SampleSite site) {
    return samples && samples->site == site ? samples->declaration : std::string();
  };
  std::string header = fmt::format(
      "ply\nformat binary_little_endian 1.0\n{}"
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n{}{}",
      samples && !samples->comment.empty() ? "comment " + samples->comment + "\n" : "", shape.vertices.rows(),
      has_cloud_normals(shape) ? normal_declaration : "", properties_at(SampleSite::vertices));
  if (!is_cloud(shape)) {
    header += fmt::format("element face {}\nproperty list uchar int vertex_indices\n{}", shape.triangles.rows(),
                          properties_at(SampleSite::faces));
  }
  return header + "end_header\n";
}

void append_doubles(std::string& bytes, const Eigen::RowVector3d& vector) {
  for (const double component : vector) append_little_endian(bytes, component);
}

/// Writes the file, with sample properties if there are any.
void write(const std::filesystem::path& path, const Shape& shape, const SampleProperties* samples) {
  require_writable(path, shape);
  std::string bytes = header_of(shape, samples);
  const bool at_vertices = samples != nullptr && samples->site == SampleSite::vertices;
  for (Eigen::Index i = 0; i < shape.vertices.rows(); ++i) {
    append_doubles(bytes, shape.vertices.row(i));
    if (has_cloud_normals(shape)) append_doubles(bytes, shape.normals.row(i));
    if (at_vertices) samples->append(bytes, i);
  }
  for (Eigen::Index f = 0; f < shape.triangles.rows(); ++f) {
    append_little_endian(bytes, std::uint8_t{3});
    for (int corner = 0; corner < 3; ++corner) append_little_endian(bytes, shape.triangles(f, corner));
    if (samples && !at_vertices) samples->append(bytes, f);
  }
  write_file_atomically(path, bytes);
}

Eigen::Index sample_count(const Shape& shape, SampleSite site) {
  return site == SampleSite::faces ? shape.triangles.rows() : shape.vertices.rows();
}

void check_ply_header(const std::string& bytes, const std::string& name) {
  TextScanner scanner(bytes, name);
  read_ply_header(scanner);
}

}  // namespace

Shape read_ply(const std::string& bytes, const std::string& name) {
  TextScanner scanner(bytes, name);
  const PlyHeader header = read_ply_header(scanner);
  if (header.encoding == PlyEncoding::ascii) return PlyBody(header, PlyTextSource(scanner)).read();
  const std::endian order = header.encoding == PlyEncoding::little_endian ? std::endian::little : std::endian::big;
  return PlyBody(header, PlyBinarySource(scanner, order)).read();
}

void write_ply(const std::filesystem::path& path, const Shape& shape, std::string_view /*comment*/) {
  write(path, shape, nullptr);
}

void write_ply(const std::filesystem::path& path, const Shape& shape, SampleSite site, const Eigen::VectorXd& values,
               const std::vector<std::array<std::uint8_t, 3>>& colours, std::string_view value_name,
               std::string_view comment) {
  const Eigen::Index samples = sample_count(shape, site);
  if (values.size() != samples || colours.size() != static_cast<std::size_t>(samples)) {
    throw InputError(fmt::format("cannot write {}: {} values and {} colours for {} samples", path.string(),
                                 values.size(), colours.size(), samples));
  }
  const SampleProperties coloured{
      .site = site,
      .declaration = fmt::format("property uchar red\nproperty uchar green\nproperty uchar blue\nproperty double {}\n",
                                 value_name),
      .append =
          [&](std::string& bytes, Eigen::Index i) {
            for (const std::uint8_t channel : colours[static_cast<std::size_t>(i)])
              append_little_endian(bytes, channel);
            append_little_endian(bytes, values[i]);
          },
      .comment = std::string(comment)};
  write(path, shape, &coloured);
}

void write_ply(const std::filesystem::path& path, Shape shape, SampleSite site, const Points& normals) {
  const Eigen::Index samples = sample_count(shape, site);
  if (normals.rows() != samples) {
    throw InputError(fmt::format("cannot write {}: {} normals for {} samples", path.string(), normals.rows(), samples));
  }
  shape.normals.resize(0, 3);
  const SampleProperties properties{
      .site = site, .declaration = std::string(normal_declaration), .append = [&](std::string& bytes, Eigen::Index i) {
        append_doubles(bytes, normals.row(i));
      }};
  write(path, shape, &properties);
}

ShapeFormat ply_format() {
  static constexpr std::array<std::string_view, 1> extensions{".ply"};
  return {.name = "PLY",
          .description = "Polygon File Format, ASCII or binary; written as binary",
          .extensions = extensions,
          .begins_like = [](std::string_view bytes) { return bytes.starts_with("ply"); },
          .check_header = check_ply_header,
          .read = read_single_file<read_ply>,
          .write = write_ply};
}

}  // namespace shapegauge
