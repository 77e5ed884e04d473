// SPDX-License-Identifier: GPL-3.0-or-later
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

/// Cache version of reading shapes; increment when a valid file is read as a different shape.
inline constexpr int shape_reading_version = 2;

/// Reads a shape from a file. The format follows from the name's extension or, failing that, from the first bytes
/// (shape_formats()).
///
/// Polygons become triangles in the file's order (Shape::polygons): a fan about the first corner if it covers the
/// polygon, otherwise the constrained Delaunay triangulation. All vertices and faces of the file are kept, including
/// duplicate, degenerate and non-manifold ones. STL has no indices; its vertices with equal coordinates are merged.
/// Without faces the shape is a point cloud.
///
/// Throws InputError for an absent, unreadable or truncated file, an index out of range, a coordinate that is not
/// finite, and a polygon of more than 100000 corners.
Shape read_shape(const std::filesystem::path& path);

/// Reads a shape from the contents of a file. `extension`, with its dot, selects the format. If it is empty, the
/// extension of the source's name or else the first bytes select the format.
Shape read_shape(const ShapeSource& source, std::string_view extension = {});

/// Returns true if a file is a shape: the extension of its name or its first bytes identify a format of
/// shape_formats().
bool is_recognised_shape(const ShapeSource& source);

/// Returns the names of the other files that a shape file refers to, such as the buffers of a glTF file, for
/// ShapeSource::neighbour(); none for most formats. Throws InputError if the names cannot be read from the source.
std::vector<std::string> shape_neighbours(const ShapeSource& source);

/// Checks only the header of a shape file. Throws InputError if the file is absent, empty, or clearly not of a format
/// in shape_formats(). Cheap enough for a whole data set before a long run.
void check_shape_header(const std::filesystem::path& path);

/// Function that writes a shape to a file atomically, in one format. `comment`, a comment line such as the one of
/// read_up_comment(), ends OFF and OBJ files; the other formats omit it. Empty for none.
using ShapeWriter = void (*)(const std::filesystem::path&, const Shape&, std::string_view comment);

/// Returns the writer for the name's extension, ignoring case. Throws InputError for an extension without a writer in
/// shape_formats().
ShapeWriter shape_writer(const std::filesystem::path& path);

/// Entry of shape_formats(): a file format of shapes with its reader and writer. Extensions are in lower case, with
/// their dot.
struct ShapeFormat {
  std::string_view name;                         ///< name of the format, such as "OFF"
  std::string_view description;                  ///< full name and properties of the format in one line, for listings
  std::span<const std::string_view> extensions;  ///< extensions of file names, such as ".off"
  /// Extensions that this format shares with unrelated files. A file with such an extension is read as a shape only if
  /// it is explicitly named as one.
  std::span<const std::string_view> ambiguous_extensions = {};
  /// Returns true if the bytes, of a whole file or its beginning, are recognisably of this format. Null for a format
  /// that only the extension identifies.
  bool (*begins_like)(std::string_view bytes) = nullptr;
  /// Throws InputError if the bytes, of a whole file or its beginning, cannot be the start of a file of this format.
  /// `name` prefixes error messages.
  void (*check_header)(const std::string& bytes, const std::string& name) = nullptr;
  /// Reads the shape; reads other files that it needs by ShapeSource::read_neighbour(). Throws InputError if the files
  /// are invalid.
  Shape (*read)(const ShapeSource& source) = nullptr;
  /// Returns the names of the other files that read() needs, such as glTF buffers; cached results depend on their
  /// contents too. Null for a format in which a shape is always a single file.
  std::vector<std::string> (*neighbours)(const ShapeSource& source) = nullptr;
  ShapeWriter write = nullptr;  ///< writes the format; null if shapegauge only reads it
  /// True if y is the vertical axis by convention, as in modelling; false for z, as in CAD, printing and scanning.
  bool y_is_up = false;
};

/// Returns the registry of shape formats: the built-in ones, listed in shape_file.cpp, followed by added ones. Entries
/// must have `check_header` and `read`, and extensions that no other entry has.
Registry<ShapeFormat>& shape_formats();

/// Returns advice on a common format that is not supported (.step, .fbx), as a sentence; nothing for other files.
std::optional<std::string> unsupported_format_advice(const std::filesystem::path& file);

/// Returns the extensions of file names, with their dot, that read_shape() recognises.
std::vector<std::string_view> shape_extensions();

/// Returns the extensions of file names that only shapes have: shape_extensions() without .txt.
std::vector<std::string_view> unambiguous_shape_extensions();

/// Returns the extensions of file names, with their dot, that shape_writer() supports.
std::vector<std::string_view> written_shape_extensions();

/// Removes the extension of a shape file, ignoring case, from a file name. Returns the whole name if it has none or an
/// ambiguous one (.txt).
std::string_view without_shape_extension(std::string_view file_name);

}  // namespace shapegauge
