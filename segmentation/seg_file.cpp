// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/segmentation/seg_file.h"

#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/scanner.h"
#include "shapegauge/core/shape/polygons.h"

namespace shapegauge {

std::vector<std::int32_t> read_seg(const std::filesystem::path& path, const Shape& mesh) {
  const auto faces = static_cast<std::size_t>(polygon_count(mesh));
  return labels_of_triangles(mesh, parse_seg(read_file_bytes(path), path.string(), faces));
}

std::vector<std::int32_t> parse_seg(const std::string& text, const std::string& name, std::size_t faces) {
  TextScanner scanner(text, name);
  std::vector<std::int32_t> labels;
  std::int64_t segment = 0;
  while (scanner.read_integer(segment, "the number of a segment")) {
    if (segment < 0 || segment > std::numeric_limits<std::int32_t>::max()) {
      scanner.fail(fmt::format("a segment has a number from 0 to {}, not {}; is this a .seg file?",
                               std::numeric_limits<std::int32_t>::max(), segment));
    }
    if (labels.size() == faces) {
      scanner.fail(fmt::format("more lines than the mesh has faces ({}); the file may be of another mesh", faces));
    }
    labels.push_back(static_cast<std::int32_t>(segment));
  }
  if (labels.size() < faces) {
    throw InputError(
        fmt::format("{}: the file has {} lines, the mesh {} faces; it may be of another mesh, or truncated", name,
                    labels.size(), faces));
  }
  return labels;
}

void write_seg(const std::filesystem::path& path, const Shape& shape, std::span<const std::int32_t> labels) {
  write_seg(path, labels_of_polygons(shape, labels));
}

void write_seg(const std::filesystem::path& path, std::span<const std::int32_t> labels) {
  std::string text;
  for (const std::int32_t label : labels) fmt::format_to(std::back_inserter(text), "{}\n", label);
  write_file_atomically(path, text);
}

}  // namespace shapegauge
