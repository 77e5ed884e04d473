#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/registry.h"
#include "shapegauge/core/io/shape_source.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Raised with every change of the shape that a valid file is read as, which makes cached results of earlier versions
/// stale.
inline constexpr int shape_reading_version = 2;

/// Reads a shape from a file of a format in shape_formats(), by the name's extension and, failing that, by the first
/// bytes. Without faces it is a point cloud. Polygons become triangles, in the file's order (Shape::polygons): a fan
/// about the first corner where that covers the polygon, else its constrained Delaunay triangulation. Every vertex and
/// every face of the file is kept: duplicates, degenerate and non-manifold faces survive. STL vertices with equal
/// coordinates are merged, as the format has no indices. Throws InputError: absent, unreadable or truncated file, index
/// out of range, coordinate that is not finite, polygon of more than 100000 corners.
Shape read_shape(const std::filesystem::path& path);

/// The same of a file that was read already. `extension`: that of the format, with its dot; empty: by the source's name
/// and its first bytes.
Shape read_shape(const ShapeSource& source, std::string_view extension = {});

/// Whether the format can be determined from the extension or from the bytes.
bool is_recognised_shape(const ShapeSource& source);

/// The names of the files beside it that the shape depends on, as ShapeSource::neighbour() takes them; none for most
/// formats. Throws InputError where the source names them in a way that cannot be read.
std::vector<std::string> shape_neighbours(const ShapeSource& source);

/// Looks at the header only: throws InputError where the file is absent, empty, or plainly not a shape of a format in
/// shape_formats(). Cheap enough to do for a whole data set before a long run.
void check_shape_header(const std::filesystem::path& path);

/// Writes a shape to a file, whole or not at all.
using ShapeWriter = void (*)(const std::filesystem::path&, const Shape&);

/// The writer for the format that the name's extension tells, in any case: of those in shape_formats() that have one.
/// Throws InputError for another extension.
ShapeWriter shape_writer(const std::filesystem::path& path);

/// A file format of shapes. Extensions are in lower case, with their dot.
struct ShapeFormat {
  std::string_view name;
  std::string_view description;  ///< one line
  std::span<const std::string_view> extensions;
  /// Extensions that are read as this format too, but may belong to anything: a file that has one is not taken for a
  /// shape unless it is named as one.
  std::span<const std::string_view> ambiguous_extensions = {};
  /// Whether the bytes, of a whole file or of its beginning, are recognisably of this format; null for a format that
  /// cannot be recognised.
  bool (*begins_like)(std::string_view bytes) = nullptr;
  /// Throws InputError where the bytes, the beginning of a file or all of it, do not begin like this format. `name`
  /// stands in front of messages.
  void (*check_header)(const std::string& bytes, const std::string& name);
  /// The shape in a file. Throws InputError. What it takes from files beside it goes through the source.
  Shape (*read)(const ShapeSource& source);
  /// Names the files beside it that read() depends on: cached results depend on them, too. Null: none.
  std::vector<std::string> (*neighbours)(const ShapeSource& source) = nullptr;
  ShapeWriter write = nullptr;  ///< null: not written
};

/// All formats of shapes: those of this folder, one file each and one line in shape_file.cpp, then those that were
/// added. An entry has extensions that no other has.
Registry<ShapeFormat>& shape_formats();

/// What to do with a file of a format that is common, but not read (.step, .fbx): a sentence; nothing for other files.
std::optional<std::string> unread_format_advice(const std::filesystem::path& file);

/// The extensions of all files that read_shape() knows by their names.
std::vector<std::string_view> shape_extensions();

/// Of these, the ones that tell a shape's file from any other: without .txt.
std::vector<std::string_view> unambiguous_shape_extensions();

/// The extensions of all files that shape_writer() writes.
std::vector<std::string_view> written_shape_extensions();

/// The file's name without the extension of a shape file, in any case; the whole name where it has none, or an
/// ambiguous one (.txt).
std::string_view without_shape_extension(std::string_view file_name);

}  // namespace shapegauge
