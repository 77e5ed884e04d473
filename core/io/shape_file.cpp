// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/io/shape_file.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <optional>
#include <utility>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/base/utf8.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/formats.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

std::vector<ShapeFormat> builtin_formats() {
  return {off_format(), obj_format(), ply_format(), stl_format(), gltf_format(), xyz_format()};
}

std::vector<std::string_view> extensions_of(const ShapeFormat& format) {
  std::vector<std::string_view> all(format.extensions.begin(), format.extensions.end());
  all.insert(all.end(), format.ambiguous_extensions.begin(), format.ambiguous_extensions.end());
  return all;
}

/// Returns the format of a lower-case extension; null if unknown.
const ShapeFormat* format_by_extension(std::string_view extension) {
  const auto has_it = [&](const ShapeFormat& format) {
    return std::ranges::count(format.extensions, extension) +
               std::ranges::count(format.ambiguous_extensions, extension) >
           0;
  };
  return shape_formats().find_if(has_it);
}

const ShapeFormat* format_by_content(std::string_view bytes) {
  return shape_formats().find_if(
      [&](const ShapeFormat& format) { return format.begins_like != nullptr && format.begins_like(bytes); });
}

std::string extension_of(const fs::path& path) { return path.extension().string(); }

/// Returns the format by extension (ignoring case) or, failing that, by content; null if unknown.
const ShapeFormat* find_format(std::string extension, std::string_view bytes) {
  const ShapeFormat* const by_extension = format_by_extension(lower_case(std::move(extension)));
  return by_extension != nullptr ? by_extension : format_by_content(bytes);
}

const ShapeFormat& format_of(std::string_view name, const std::string& extension, std::string_view bytes) {
  if (const ShapeFormat* const format = find_format(extension, bytes)) return *format;
  if (const auto advice = unsupported_format_advice("x" + extension))
    throw InputError(fmt::format("{}: {}", name, *advice));
  throw InputError(fmt::format("{}: unknown shape format \"{}\"; known are {}", name, extension,
                               fmt::join(shape_extensions(), ", ")));
}

const ShapeFormat& format_of(const ShapeSource& source) {
  return format_of(source.name, extension_of(source.name), source.bytes);
}

void check_format(const ShapeFormat& format) {
  for (const std::string_view extension : extensions_of(format)) {
    if (format_by_extension(extension) != nullptr) {
      throw ArgumentError(fmt::format("another shape format already has the extension \"{}\"", extension));
    }
  }
}

}  // namespace

Shape read_shape(const fs::path& path) { return read_shape(read_shape_source(path)); }

Shape read_shape(const ShapeSource& source, std::string_view extension) {
  const ShapeFormat& format =
      extension.empty() ? format_of(source) : format_of(source.name, std::string(extension), source.bytes);
  Shape shape = format.read(source);
  if (shape.vertices.rows() == 0) throw InputError(fmt::format("{}: no vertices", source.name));
  return shape;
}

bool is_recognised_shape(const ShapeSource& source) {
  return find_format(extension_of(source.name), source.bytes) != nullptr;
}

std::vector<std::string> shape_neighbours(const ShapeSource& source) {
  const ShapeFormat& format = format_of(source);
  return format.neighbours != nullptr ? format.neighbours(source) : std::vector<std::string>();
}

void check_shape_header(const fs::path& path) {
  constexpr std::size_t usual_size_of_header = std::size_t{1} << 16U;
  std::string bytes = read_file_bytes(path, usual_size_of_header);
  bool is_whole = bytes.size() < usual_size_of_header;
  bytes = to_utf8(std::move(bytes));
  if (!is_whole && find_format(extension_of(path), bytes) == nullptr) {
    bytes = read_shape_source(path).bytes;
    is_whole = true;
  }
  const ShapeFormat& format = format_of(path.string(), extension_of(path), bytes);
  try {
    format.check_header(bytes, path.string());
  } catch (const InputError&) {
    if (is_whole) throw;
    format.check_header(read_shape_source(path).bytes, path.string());  // long comments, perhaps
  }
}

ShapeWriter shape_writer(const fs::path& path) {
  const ShapeFormat* const format = format_by_extension(lower_case(path.extension().string()));
  if (format != nullptr && format->write != nullptr) return format->write;
  throw InputError(fmt::format("cannot write {}: the name must end in one of {}", path.string(),
                               fmt::join(written_shape_extensions(), ", ")));
}

Registry<ShapeFormat>& shape_formats() {
  static Registry<ShapeFormat> all("format of shapes", builtin_formats(),
                                   has_functions<&ShapeFormat::check_header, &ShapeFormat::read>, check_format);
  return all;
}

std::optional<std::string> unsupported_format_advice(const fs::path& file) {
  struct UnreadFormat {
    std::string_view extension;
    std::string_view advice;
  };
  constexpr std::string_view solid = "CAD models have no triangles; export it as STL";
  constexpr std::string_view scene = "export the model as glTF, PLY or OBJ";
  static constexpr std::array unread{UnreadFormat{".step", solid},
                                     UnreadFormat{".stp", solid},
                                     UnreadFormat{".iges", solid},
                                     UnreadFormat{".igs", solid},
                                     UnreadFormat{".brep", solid},
                                     UnreadFormat{".sldprt", solid},
                                     UnreadFormat{".f3d", solid},
                                     UnreadFormat{".fcstd", solid},
                                     UnreadFormat{".fbx", scene},
                                     UnreadFormat{".blend", scene},
                                     UnreadFormat{".3ds", scene},
                                     UnreadFormat{".max", scene},
                                     UnreadFormat{".dae", scene},
                                     UnreadFormat{".usd", scene},
                                     UnreadFormat{".usdz", scene},
                                     UnreadFormat{".usda", scene},
                                     UnreadFormat{".usdc", scene},
                                     UnreadFormat{".wrl", scene},
                                     UnreadFormat{".x3d", scene},
                                     UnreadFormat{".skp", scene},
                                     UnreadFormat{".3dm", scene},
                                     UnreadFormat{".3mf", "export the model as STL or PLY"},
                                     UnreadFormat{".amf", "export the model as STL or PLY"},
                                     UnreadFormat{".las", "export the points as PLY or as lines of x y z"},
                                     UnreadFormat{".laz", "export the points as PLY or as lines of x y z"},
                                     UnreadFormat{".e57", "export the points as PLY or as lines of x y z"},
                                     UnreadFormat{".pcd", "export the points as PLY or as lines of x y z"},
                                     UnreadFormat{".vtk", "export the surface as PLY or STL"},
                                     UnreadFormat{".msh", "export the surface as PLY or STL"}};
  const auto* const found = std::ranges::find(unread, lower_case(extension_of(file)), &UnreadFormat::extension);
  if (found == unread.end()) return std::nullopt;
  return fmt::format("{} files are not supported: {}", found->extension, found->advice);
}

std::vector<std::string_view> shape_extensions() {
  std::vector<std::string_view> all;
  for (const ShapeFormat& format : shape_formats().entries())
    std::ranges::copy(extensions_of(format), std::back_inserter(all));
  return all;
}

std::vector<std::string_view> unambiguous_shape_extensions() {
  std::vector<std::string_view> all;
  for (const ShapeFormat& format : shape_formats().entries())
    std::ranges::copy(format.extensions, std::back_inserter(all));
  return all;
}

std::vector<std::string_view> written_shape_extensions() {
  std::vector<std::string_view> all;
  for (const ShapeFormat& format : shape_formats().entries()) {
    if (format.write != nullptr) std::ranges::copy(format.extensions, std::back_inserter(all));
  }
  return all;
}

std::string_view without_shape_extension(std::string_view file_name) {
  const std::size_t dot = file_name.rfind('.');
  if (dot == std::string_view::npos || dot == 0) return file_name;
  const std::string extension = lower_case(std::string(file_name.substr(dot)));
  const auto has_it = [&](const ShapeFormat& format) { return std::ranges::count(format.extensions, extension) > 0; };
  return shape_formats().find_if(has_it) != nullptr ? file_name.substr(0, dot) : file_name;
}

}  // namespace shapegauge
