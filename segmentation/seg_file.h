// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Reads a segmentation in the Princeton Segmentation Benchmark's format: one line per face of the mesh's file, in
/// order, with the non-negative number of its segment. Returns the numbers by triangle, each from its polygon. Throws
/// InputError if the file cannot be read, for a number of lines that differs from the number of faces, and for an
/// invalid line.
std::vector<std::int32_t> read_seg(const std::filesystem::path& path, const Shape& mesh);

/// Parses the numbers of faces from such a text; `name` prefixes error messages.
std::vector<std::int32_t> parse_seg(const std::string& text, const std::string& name, std::size_t faces);

/// Writes a segmentation, given by triangle or point, in that format, atomically. A polygon gets the number with the
/// largest area in it. Throws InputError if the file cannot be written.
void write_seg(const std::filesystem::path& path, const Shape& shape, std::span<const std::int32_t> labels);

/// Writes one line per label, atomically. Throws InputError if the file cannot be written.
void write_seg(const std::filesystem::path& path, std::span<const std::int32_t> labels);

}  // namespace shapegauge
