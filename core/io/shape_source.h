// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// File of a shape as seen by the reader of a format: its bytes, and access to the neighbouring files that it refers
/// to, such as the buffers of a `.gltf`.
struct ShapeSource {
  std::string bytes;  ///< contents of the whole file
  std::string name;   ///< path of the file, or another name; prefixes error messages
  /// Folder of the file and its neighbours; absent if the bytes are not from a file (standard input).
  std::optional<std::filesystem::path> folder = {};

  /// Resolves the path of a file in the folder or below it. `file` is relative to the folder, with `/` as separator, as
  /// in the shape's file (a URI must be decoded).
  ///
  /// Throws InputError if there is no folder, and for a name that leads out of it: an absolute path, a component "..",
  /// or a URI with a scheme. Follows symbolic links within the folder.
  [[nodiscard]] std::filesystem::path neighbour(std::string_view file) const;

  /// Reads the file at neighbour(file). Throws InputError as neighbour() does, and if the file is absent, unreadable,
  /// empty, or not a regular file.
  [[nodiscard]] std::string read_neighbour(std::string_view file) const;
};

/// Reads a whole shape file as a source, named by its path; a text in UTF-16 is converted (to_utf8()). Throws
/// InputError as read_file_bytes() does.
ShapeSource read_shape_source(const std::filesystem::path& path);

/// Adapts a format's reader that needs only the bytes and name of one file to the signature of ShapeFormat::read.
template <Shape (*read)(const std::string& bytes, const std::string& name)>
Shape read_single_file(const ShapeSource& source) {
  return read(source.bytes, source.name);
}

}  // namespace shapegauge
