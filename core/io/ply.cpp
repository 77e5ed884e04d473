#include "shapegauge/core/io/ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fmt/format.h>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/little_endian.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/scanner.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/io/shape_format.h"
#include "shapegauge/core/io/triangulate_polygon.h"

namespace shapegauge {

namespace {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  bool list = false;
  PlyType count_type = PlyType::uint8;  ///< of a list's length
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
};

/// Sequential values of an ASCII PLY file's body. Every reading function returns false at the end.
class PlyTextSource {
 public:
  explicit PlyTextSource(const TextScanner& body) : body_(body) {}

  bool read_real(double& value, PlyType /*type*/) { return body_.read_number(value, "a coordinate"); }
  bool read_whole(std::int64_t& value, PlyType /*type*/) { return body_.read_integer(value, "an index or a length"); }
  bool skip(PlyType /*type*/, std::uint64_t count) { return body_.skip_words(count); }
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
    return with_type(type, [&](auto example) { return bytes_.skip(sizeof(example) * count); });
  }
  [[nodiscard]] std::size_t remaining() const { return bytes_.remaining(); }
  [[noreturn]] void fail(std::string_view message) const { text_.fail_whole(message); }

 private:
  /// Calls the function with a number of the type.
  template <typename Function>
  static bool with_type(PlyType type, Function function) {
    switch (type) {
      case PlyType::int8:
        return function(std::int8_t{});
      case PlyType::uint8:
        return function(std::uint8_t{});
      case PlyType::int16:
        return function(std::int16_t{});
      case PlyType::uint16:
        return function(std::uint16_t{});
      case PlyType::int32:
        return function(std::int32_t{});
      case PlyType::uint32:
        return function(std::uint32_t{});
      case PlyType::float32:
        return function(float{});
      case PlyType::float64:
        return function(double{});
    }
    return false;
  }

  template <typename Value>
  bool read_as(Value& value, PlyType type) {
    return with_type(type, [&](auto number) {
      if (!bytes_.read(number)) return false;
      value = static_cast<Value>(+number);
      return true;
    });
  }

  TextScanner text_;
  ByteScanner bytes_;
};

PlyType read_type(TextScanner& scanner) {
  static constexpr std::array<std::pair<std::string_view, PlyType>, 16> names = {{
      {"char", PlyType::int8},
      {"int8", PlyType::int8},
      {"uchar", PlyType::uint8},
      {"uint8", PlyType::uint8},
      {"short", PlyType::int16},
      {"int16", PlyType::int16},
      {"ushort", PlyType::uint16},
      {"uint16", PlyType::uint16},
      {"int", PlyType::int32},
      {"int32", PlyType::int32},
      {"uint", PlyType::uint32},
      {"uint32", PlyType::uint32},
      {"float", PlyType::float32},
      {"float32", PlyType::float32},
      {"double", PlyType::float64},
      {"float64", PlyType::float64},
  }};
  const std::string_view word = scanner.read_word();
  for (const auto& [name, type] : names) {
    if (word == name) return type;
  }
  scanner.fail(fmt::format("\"{}\" is not a type of PLY", word));
}

PlyEncoding read_encoding(TextScanner& scanner) {
  const std::string_view word = scanner.read_word();
  if (word == "ascii") return PlyEncoding::ascii;
  if (word == "binary_little_endian") return PlyEncoding::little_endian;
  if (word == "binary_big_endian") return PlyEncoding::big_endian;
  scanner.fail(fmt::format("\"{}\" is not a PLY format", word));
}

PlyElement read_element(TextScanner& scanner) {
  PlyElement element;
  element.name = scanner.read_word();
  if (!scanner.read_integer(element.count, "the number of elements")) scanner.fail_whole("ends within its header");
  if (element.count < 0) scanner.fail(fmt::format("the number of elements cannot be {}", element.count));
  return element;
}

bool is_integer(PlyType type) { return type != PlyType::float32 && type != PlyType::float64; }

PlyProperty read_property(TextScanner& scanner) {
  PlyProperty property;
  TextScanner ahead = scanner;
  property.list = ahead.read_word() == "list";
  if (property.list) {
    scanner = ahead;
    property.count_type = read_type(scanner);
    if (!is_integer(property.count_type)) scanner.fail("the length of a list must be of an integer type");
  }
  property.type = read_type(scanner);
  property.name = scanner.read_word();
  return property;
}

/// Returns true if the first line of the text ends with CR alone.
bool ends_lines_with_cr(std::string_view text) {
  const std::size_t start = text.find_first_of("\r\n");
  return start != std::string_view::npos && text[start] == '\r' && !text.substr(start).starts_with("\r\n");
}

/// Reads a PLY file's header (Greg Turk, "The PLY Polygon File Format") and leaves the scanner at the first byte of the
/// body. Throws InputError, with the line, for an invalid header.
PlyHeader read_ply_header(TextScanner& scanner) {
  if (scanner.read_word() != "ply") scanner.fail("not a PLY file: it does not begin with \"ply\"");
  const bool cr_alone = ends_lines_with_cr(scanner.rest());
  PlyHeader header;
  bool has_format = false;
  while (true) {
    const std::string_view word = scanner.read_word();
    if (word.empty()) scanner.fail_whole("ends within its header");
    if (word == "end_header") {
      scanner.skip_line();
      break;
    }
    if (word == "format") {
      header.encoding = read_encoding(scanner);
      has_format = true;
    } else if (word == "element") {
      header.elements.push_back(read_element(scanner));
    } else if (word == "property") {
      if (header.elements.empty()) scanner.fail("a property before the first element");
      header.elements.back().properties.push_back(read_property(scanner));
    } else if (word != "comment" && word != "obj_info") {
      scanner.fail(fmt::format("\"{}\" does not belong in a PLY header", word));
    }
    scanner.skip_line();
  }
  if (!has_format) scanner.fail("the header names no format");
  // The last line may end otherwise than the first. After CR alone, the body's first byte may look like LF.
  const std::size_t line_end = scanner.rest().starts_with("\r\n") && !cr_alone ? 2 : 1;
  scanner.advance(std::min(line_end, scanner.remaining()));
  return header;
}

/// Returns the index of a vertex property: 0 to 2 for coordinates, 3 to 5 for the normal, 6 for any other.
std::size_t place_of(const PlyProperty& property) {
  constexpr std::array<std::string_view, 6> names = {"x", "y", "z", "nx", "ny", "nz"};
  if (property.list) return names.size();
  return static_cast<std::size_t>(std::ranges::find(names, property.name) - names.begin());
}

/// Returns true if all components of a vector, beginning at an index, have one property each.
bool has_vector(const PlyElement& element, std::size_t first_place) {
  return std::ranges::all_of(std::array{0U, 1U, 2U}, [&](std::size_t axis) {
    return std::ranges::count(element.properties, first_place + axis, place_of) == 1;
  });
}

bool holds_corners(const PlyProperty& property) {
  return property.list && (property.name == "vertex_indices" || property.name == "vertex_index");
}

const PlyElement* find_element(const PlyHeader& header, std::string_view name) {
  const auto found = std::ranges::find(header.elements, name, &PlyElement::name);
  return found == header.elements.end() ? nullptr : &*found;
}

void require_vertices(const PlyHeader& header, const TextScanner& scanner) {
  const PlyElement* const vertex = find_element(header, "vertex");
  if (vertex == nullptr) scanner.fail_whole("its header has no element \"vertex\"");
  if (std::ranges::count(header.elements, "vertex", &PlyElement::name) > 1) {
    scanner.fail_whole("its header has two elements \"vertex\"");
  }
  if (vertex->count > std::numeric_limits<std::int32_t>::max()) {
    scanner.fail_whole(
        fmt::format("{} vertices: at most {} can be read", vertex->count, std::numeric_limits<std::int32_t>::max()));
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (std::ranges::count(vertex->properties, axis, place_of) != 1) {
      scanner.fail_whole(fmt::format("its element \"vertex\" needs one property \"{}\"", "xyz"[axis]));
    }
  }
}

void require_readable_faces(const PlyHeader& header, const TextScanner& scanner) {
  for (const std::string name : {"face", "tristrips"}) {
    if (std::ranges::count(header.elements, name, &PlyElement::name) > 1) {
      scanner.fail_whole(fmt::format("its header has two elements \"{}\"", name));
    }
    const PlyElement* const face = find_element(header, name);
    if (face == nullptr || face->count == 0) continue;
    if (face->count > std::numeric_limits<std::int32_t>::max()) {
      scanner.fail_whole(
          fmt::format("{} faces: at most {} can be read", face->count, std::numeric_limits<std::int32_t>::max()));
    }
    const auto corners = std::ranges::find_if(face->properties, holds_corners);
    if (corners == face->properties.end()) {
      scanner.fail_whole(fmt::format("its element \"{}\" has no list \"vertex_indices\" or \"vertex_index\"", name));
    }
    if (std::any_of(corners + 1, face->properties.end(), holds_corners)) {
      scanner.fail_whole(fmt::format("its element \"{}\" has two lists of vertices", name));
    }
    if (!is_integer(corners->type)) scanner.fail_whole("the indices of its faces are not of an integer type");
  }
}

PlyHeader read_checked_header(TextScanner& scanner) {
  PlyHeader header = read_ply_header(scanner);
  require_vertices(header, scanner);
  require_readable_faces(header, scanner);
  return header;
}

/// Reads the body of a PLY file from a PlyTextSource or a PlyBinarySource.
template <typename Source>
class PlyBody {
 public:
  PlyBody(const PlyHeader& header, Source source)
      : header_(header), source_(std::move(source)), vertices_(find_element(header, "vertex")->count) {
    // Limited by the size of the file, whatever its header announces: a coordinate takes at least a byte and a
    // separator.
    const PlyElement* const face = find_element(header, "face");
    const PlyElement& vertex = *find_element(header, "vertex");
    // The normals of a mesh are ignored.
    numbers_read_ = (face == nullptr || face->count == 0) && has_vector(vertex, 3) ? 6 : 3;
    std::ranges::transform(vertex.properties, std::back_inserter(vertex_numbers_), place_of);
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
      if (!holds_corners(property)) return skip(property);
      if (element.name == "tristrips") return read_strips(property, i);
      return element.name == "face" ? read_corners(property, i) : skip(property);
    });
  }

  bool read_vertex(const PlyElement& element, std::int64_t i) {
    std::array<double, 6> numbers = {};  // the position and the normal
    for (std::size_t k = 0; k < vertex_numbers_.size(); ++k) {
      const PlyProperty& property = element.properties[k];
      const std::size_t place = vertex_numbers_[k];
      if (place >= numbers_read_ ? !skip(property) : !source_.read_real(numbers[place], property.type)) return false;
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

  /// Adds a triangle; one with a repeated corner only leads to another place of the strip.
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
  std::vector<std::size_t> vertex_numbers_;  ///< place_of() of the vertices' properties
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
  const bool at_vertices = samples && samples->site == SampleSite::vertices;
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

}  // namespace

Shape read_ply(const std::string& bytes, const std::string& name) {
  TextScanner scanner(bytes, name);
  const PlyHeader header = read_checked_header(scanner);
  if (header.encoding == PlyEncoding::ascii) return PlyBody(header, PlyTextSource(scanner)).read();
  const std::endian order = header.encoding == PlyEncoding::little_endian ? std::endian::little : std::endian::big;
  return PlyBody(header, PlyBinarySource(scanner, order)).read();
}

void check_ply_header(const std::string& bytes, const std::string& name) {
  TextScanner scanner(bytes, name);
  read_checked_header(scanner);
}

void write_ply(const std::filesystem::path& path, const Shape& shape) { write(path, shape, nullptr); }

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
          .read = read_alone<read_ply>,
          .write = write_ply};
}

}  // namespace shapegauge
