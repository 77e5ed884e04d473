#pragma once

#include <filesystem>
#include <vector>

namespace shapegauge {

/// Whether the name ends like that of a shape file (.off, .obj, .ply, .stl, .xyz, .pwn, .pts, in any case) and is not
/// hidden. A .txt file may be anything, and is not counted.
bool is_model_file(const std::filesystem::path& path);

/// The shape files right in the folder, in natural order of their names.
std::vector<std::filesystem::path> model_files(const std::filesystem::path& folder);

/// The folders right in the folder that are not hidden, in natural order of their names.
std::vector<std::filesystem::path> subfolders(const std::filesystem::path& folder);

}  // namespace shapegauge
