// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/shape/polygons.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/promises.h"

namespace shapegauge::fuzz {

namespace {

void promise_sound(const Shape& shape) {
  promise(shape.vertices.allFinite(), "coordinates are finite");
  if (shape.triangles.rows() == 0) return;
  promise(shape.triangles.minCoeff() >= 0, "indices are not negative");
  promise(shape.triangles.maxCoeff() < shape.vertices.rows(), "indices are within range");
  if (!has_polygons(shape)) return;
  const std::vector<std::int32_t>& polygons = shape.polygons.of_triangle;
  promise(std::ssize(polygons) == shape.triangles.rows(), "every triangle is of a polygon");
  promise(std::ranges::is_sorted(polygons), "triangles are in the order of the polygons");
  promise(polygons.front() >= 0 && polygons.back() < polygon_count(shape), "polygons are within range");
}

/// The reader and the check of headers before long runs, which must accept every readable file.
bool read_with(const ShapeFormat& format, std::string_view bytes) {
  const ShapeSource source{.bytes = std::string(bytes), .name = "shape"};
  const bool is_read = is_accepted("shape:", [&] { promise_sound(format.read(source)); });
  const bool is_checked = is_accepted("shape:", [&] { format.check_header(source.bytes, source.name); });
  promise(!is_read || is_checked, "the header of what can be read is accepted");
  return is_read;
}

}  // namespace

bool read_off(std::string_view bytes) { return read_with(off_format(), bytes); }
bool read_obj(std::string_view bytes) { return read_with(obj_format(), bytes); }
bool read_ply(std::string_view bytes) { return read_with(ply_format(), bytes); }
bool read_stl(std::string_view bytes) { return read_with(stl_format(), bytes); }
bool read_gltf(std::string_view bytes) { return read_with(gltf_format(), bytes); }

}  // namespace shapegauge::fuzz
