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

/// Computes sha256_of_file(); empty if the file cannot be read or is empty.
std::string sha256_of_file_if_readable(const std::filesystem::path& path);

/// Computes the hash of everything that a shape depends on: that of its file or, if the shape depends on neighbouring
/// files (shape_neighbours()), of the hashes and names of all. Skips files that cannot be read, which read_shape()
/// reports.
std::string sha256_of_shape(const ShapeSource& source);

/// Reads a shape's file and computes sha256_of_shape(); empty if the file cannot be read.
std::string sha256_if_readable(const std::filesystem::path& path);

}  // namespace shapegauge
