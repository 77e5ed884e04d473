#include "shapegauge/core/io/read_ply.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <limits>

#include "shapegauge/core/io/ply_header.h"
#include "shapegauge/core/io/ply_source.h"
#include "shapegauge/core/io/reading_errors.h"
#include "shapegauge/core/io/soup_builder.h"

namespace shapegauge {

namespace {

/// Number of the coordinate that a vertex's property is, 3 to 5 for the components of its normal, 6 for any other.
std::size_t place_of(const PlyProperty& property) {
  constexpr std::array<std::string_view, 6> names = {"x", "y", "z", "nx", "ny", "nz"};
  if (property.list) return names.size();
  return static_cast<std::size_t>(std::ranges::find(names, property.name) - names.begin());
}

/// Whether every component of a vector has one property of the element, the first component's place being given.
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
  if (find_element(header, "tristrips") != nullptr) {
    scanner.fail_whole("it holds triangle strips, which are not read; convert them to faces");
  }
  if (std::ranges::count(header.elements, "face", &PlyElement::name) > 1) {
    scanner.fail_whole("its header has two elements \"face\"");
  }
  const PlyElement* const face = find_element(header, "face");
  if (face == nullptr || face->count == 0) return;
  const auto corners = std::ranges::find_if(face->properties, holds_corners);
  if (corners == face->properties.end()) {
    scanner.fail_whole("its element \"face\" has no list \"vertex_indices\" or \"vertex_index\"");
  }
  if (std::any_of(corners + 1, face->properties.end(), holds_corners)) {
    scanner.fail_whole("its element \"face\" has two lists of vertices");
  }
  if (corners->type == PlyType::float32 || corners->type == PlyType::float64) {
    scanner.fail_whole("the indices of its faces are not of an integer type");
  }
}

PlyHeader read_checked_header(TextScanner& scanner) {
  PlyHeader header = read_ply_header(scanner);
  require_vertices(header, scanner);
  require_readable_faces(header, scanner);
  return header;
}

/// Reads the body of a PLY file, whose values come from a PlyTextSource or a PlyBinarySource.
template <typename Source>
class PlyBody {
 public:
  PlyBody(const PlyHeader& header, Source source)
      : header_(header), source_(std::move(source)), vertices_(find_element(header, "vertex")->count) {
    // What the file has room for, whatever its header claims: a coordinate takes a byte and a separator, or more.
    const PlyElement* const face = find_element(header, "face");
    const PlyElement& vertex = *find_element(header, "vertex");
    // The normals of a mesh are of no interest, whatever they are.
    places_read_ = (face == nullptr || face->count == 0) && has_vector(vertex, 3) ? 6 : 3;
    std::ranges::transform(vertex.properties, std::back_inserter(vertex_places_), place_of);
    soup_.reserve(std::min<std::size_t>(vertices_, source_.remaining() / 3),
                  std::min<std::size_t>(face == nullptr ? 0 : face->count, source_.remaining() / 4));
  }

  Shape read() {
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;
      for (std::int64_t i = 0; i < element.count; ++i) {
        if (!read_item(element, i)) source_.fail(message_truncated(i, element.count, name_of_items(element)));
      }
      if (element.name == "face" && element.count > 0 && soup_.triangles() == 0) {
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
      return element.name == "face" && holds_corners(property) ? read_corners(property, i) : skip(property);
    });
  }

  bool read_vertex(const PlyElement& element, std::int64_t i) {
    std::array<double, 6> numbers = {};  // the position and the normal
    for (std::size_t k = 0; k < vertex_places_.size(); ++k) {
      const PlyProperty& property = element.properties[k];
      const std::size_t place = vertex_places_[k];
      if (place >= places_read_ ? !skip(property) : !source_.read_real(numbers[place], property.type)) return false;
    }
    const auto [x, y, z, nx, ny, nz] = numbers;
    if (!is_finite({x, y, z})) source_.fail(message_not_finite(i));
    soup_.add_vertex({x, y, z});
    if (places_read_ == 6) {
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
    soup_.begin_face();
    for (std::int64_t k = 0; k < corners; ++k) {
      std::int64_t vertex = 0;
      if (!source_.read_whole(vertex, property.type)) return false;
      if (vertex < 0 || vertex >= vertices_) source_.fail(message_no_such_vertex(i, vertex, vertices_));
      soup_.add_corner(static_cast<std::int32_t>(vertex));
    }
    return true;
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
  std::vector<std::size_t> vertex_places_;  ///< of the vertices' properties, see place_of()
  std::size_t places_read_ = 3;             ///< the lower ones are read, the others skipped
  SoupBuilder soup_;
};

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

}  // namespace shapegauge
