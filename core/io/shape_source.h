#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// A shape's file as the reader of a format sees it: its bytes, and the files beside it that it names, such as the
/// buffers of a `.gltf`.
struct ShapeSource {
  std::string bytes;  ///< whole
  std::string name;   ///< prefixes error messages
  /// The file's folder, where its neighbours are; absent where the bytes come from no file (standard input).
  std::optional<std::filesystem::path> folder = {};

  /// The path of a file in the folder or below it. `file`: relative to the folder, with `/` between its parts, as the
  /// shape's file has it (of a URI: decoded).
  ///
  /// Throws InputError where there is no folder, and for a name that leads out of it: absolute, with a part "..", a URI
  /// with a scheme. Symbolic links within the folder are followed.
  [[nodiscard]] std::filesystem::path neighbour(std::string_view file) const;

  /// The bytes of that file, at most `limit` of them from its beginning. Throws InputError, also where it is absent,
  /// unreadable, empty, or not a regular file.
  [[nodiscard]] std::string read_neighbour(std::string_view file,
                                           std::size_t limit = std::numeric_limits<std::size_t>::max()) const;
};

/// A file as a source, read whole; messages call it by its path. Throws InputError as read_file_bytes().
ShapeSource read_shape_source(const std::filesystem::path& path);

/// ShapeFormat::read of a format whose files name no others: a function of the bytes and of the name in messages.
template <Shape (*read)(const std::string& bytes, const std::string& name)>
Shape read_alone(const ShapeSource& source) {
  return read(source.bytes, source.name);
}

}  // namespace shapegauge
