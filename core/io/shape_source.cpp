// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/io/shape_source.h"

#include <algorithm>
#include <fmt/format.h>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/text.h"
#include "shapegauge/core/base/utf8.h"
#include "shapegauge/core/io/file_bytes.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

/// Returns why a name is not that of a neighbour; empty for a valid name.
std::string_view objection_to(std::string_view file) {
  if (file.empty()) return "the name is empty";
  if (file.find('\0') != std::string_view::npos) return "the name has a zero byte";
  if (file.find("://") != std::string_view::npos) return "files elsewhere are not fetched; put the file next to it";
  const fs::path path(file);
  if (path.is_absolute()) return "the path is absolute; put the file next to it and give its name only";
  if (std::ranges::count(path, fs::path("..")) > 0) return "the path leads out of the folder; put the file next to it";
  return {};
}

}  // namespace

fs::path ShapeSource::neighbour(std::string_view file) const {
  const auto fail = [&](std::string_view why) {
    throw InputError(fmt::format("{}: cannot open {}, which it refers to: {}", name, quoted_word(file), why));
  };
  if (const std::string_view objection = objection_to(file); !objection.empty()) fail(objection);
  if (!folder) fail("standard input has no folder; name the shape's file");
  return *folder / file;
}

std::string ShapeSource::read_neighbour(std::string_view file) const {
  const fs::path path = neighbour(file);
  try {
    return read_file_bytes(path);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", name, error.what()));
  }
}

ShapeSource read_shape_source(const fs::path& path) {
  return {.bytes = to_utf8(read_file_bytes(path)), .name = path.string(), .folder = path.parent_path()};
}

}  // namespace shapegauge
