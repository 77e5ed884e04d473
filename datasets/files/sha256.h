// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "shapegauge/core/io/shape_source.h"

namespace shapegauge {

/// Computes SHA-256 of bytes, as 64 hexadecimal digits like sha256sum.
std::string sha256(std::string_view bytes);

/// Computes SHA-256 of a file's contents. Throws InputError if it cannot be read or is empty.
std::string sha256_of_file(const std::filesystem::path& path);

/// Computes sha256_of_file(). Returns an empty string if the file cannot be read or is empty.
std::string sha256_of_file_if_readable(const std::filesystem::path& path);

/// Computes the SHA-256 hash of all files that a shape depends on: the hash of its file or, if the shape depends on
/// neighbouring files (shape_neighbours()), the hash of the hashes and names of all files. Skips unreadable files,
/// which read_shape() reports.
std::string sha256_of_shape(const ShapeSource& source);

/// Reads a shape's file and computes sha256_of_shape(). Returns an empty string if the file cannot be read.
std::string sha256_if_readable(const std::filesystem::path& path);

}  // namespace shapegauge
