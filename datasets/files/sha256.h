#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "shapegauge/core/io/shape_source.h"

namespace shapegauge {

/// SHA-256 of the bytes, 64 hexadecimal digits, as sha256sum prints it.
std::string sha256(std::string_view bytes);

/// The same of a file's contents. Throws InputError where it cannot be read or is empty.
std::string sha256_of_file(const std::filesystem::path& path);

/// The hash of everything that a shape depends on: that of the file and, where it depends on files beside it
/// (shape_neighbours()), of the hashes and names of all. Files that cannot be read, which read_shape() reports,
/// are left out.
std::string sha256_of_shape(const ShapeSource& source);

}  // namespace shapegauge
