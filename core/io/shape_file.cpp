#include "shapegauge/core/io/shape_file.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/obj.h"
#include "shapegauge/core/io/off.h"
#include "shapegauge/core/io/ply.h"
#include "shapegauge/core/io/stl.h"
#include "shapegauge/core/io/xyz.h"

namespace shapegauge {

namespace fs = std::filesystem;

namespace {

struct Format {
  std::string_view extension;
  Shape (*read)(const std::string& bytes, const std::string& name);
  void (*check_header)(const std::string& bytes, const std::string& name);
};

constexpr std::array<Format, 8> formats = {{
    {".off", read_off, check_off_header},
    {".obj", read_obj, check_obj_header},
    {".ply", read_ply, check_ply_header},
    {".stl", read_stl, check_stl_header},
    {".xyz", read_xyz, check_xyz_header},
    {".pwn", read_xyz, check_xyz_header},
    {".pts", read_xyz, check_xyz_header},
    {".txt", read_xyz, check_xyz_header},
}};

std::string lower_case(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

/// The extension that the first bytes ask for. Only what names itself counts: an OFF file with its keyword, PLY, and
/// ASCII STL; an OBJ file, a binary STL file or lines of numbers could be anything.
std::string_view extension_by_content(std::string_view bytes) {
  if (bytes.starts_with("ply")) return ".ply";
  if (bytes.starts_with("solid")) return ".stl";
  const std::string_view first_line = bytes.substr(0, bytes.find_first_of("\r\n"));
  return first_line.find("OFF") != std::string_view::npos ? ".off" : "";
}

const Format& format_of(const fs::path& path, std::string_view bytes) {
  const auto find = [](std::string_view extension) {
    return std::ranges::find(formats, extension, &Format::extension);
  };
  const auto* format = find(lower_case(path.extension().string()));
  if (format == formats.end()) format = find(extension_by_content(bytes));
  if (format == formats.end()) {
    std::vector<std::string_view> extensions;
    for (const Format& known : formats) extensions.push_back(known.extension);
    throw InputError(fmt::format("{}: unknown shape format \"{}\"; known are {}", path.string(),
                                 path.extension().string(), fmt::join(extensions, ", ")));
  }
  return *format;
}

}  // namespace

Shape read_shape(const fs::path& path) { return read_shape(read_file_bytes(path), path); }

Shape read_shape(const std::string& bytes, const fs::path& path) {
  Shape shape = format_of(path, bytes).read(bytes, path.string());
  if (shape.vertices.rows() == 0) throw InputError(fmt::format("{}: it holds no vertex", path.string()));
  return shape;
}

void check_shape_header(const fs::path& path) {
  constexpr std::size_t usual_size_of_header = std::size_t{1} << 16U;
  const std::string bytes = read_file_bytes(path, usual_size_of_header);
  const Format& format = format_of(path, bytes);
  try {
    format.check_header(bytes, path.string());
  } catch (const InputError&) {
    if (bytes.size() < usual_size_of_header) throw;
    format.check_header(read_file_bytes(path), path.string());  // long comments, perhaps
  }
}

ShapeWriter shape_writer(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension == ".off" || extension == ".OFF") return write_off;
  if (extension == ".ply" || extension == ".PLY") return write_ply;
  throw InputError(fmt::format("cannot write {}: the name must end in .off or .ply", path.string()));
}

}  // namespace shapegauge
