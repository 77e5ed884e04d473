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
/// order, with the non-negative number of its segment. Returns one number per triangle, that of its polygon. Throws
/// InputError if the file cannot be read, for a number of lines that differs from the number of faces, and for an
/// invalid line.
std::vector<std::int32_t> read_seg(const std::filesystem::path& path, const Shape& mesh);

/// Parses a text in the format of read_seg(): returns one segment number per face, in order. `name` prefixes error
/// messages. Throws InputError for an invalid line, and unless there are `faces` lines.
std::vector<std::int32_t> parse_seg(const std::string& text, const std::string& name, std::size_t faces);

/// Writes a segmentation, one label per triangle or point of the shape, in the format of read_seg(), atomically. Each
/// polygon has one line: the label that covers the largest area of the polygon. Throws InputError if the file cannot be
/// written.
void write_seg(const std::filesystem::path& path, const Shape& shape, std::span<const std::int32_t> labels);

/// Writes labels in the format of read_seg(), one per line, atomically. Throws InputError if the file cannot be
/// written.
void write_seg(const std::filesystem::path& path, std::span<const std::int32_t> labels);

}  // namespace shapegauge
