#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Reads a segmentation in the Princeton Segmentation Benchmark's format: for each face of the mesh's file, in its
/// order, a line with the number of its segment, 0 or more. Returns the numbers of the triangles; each has that of its
/// polygon. Throws InputError where the file cannot be read, has another number of lines than the mesh's file has
/// faces, or holds what is no such number.
std::vector<std::int32_t> read_seg(const std::filesystem::path& path, const Shape& mesh);

/// The numbers of the faces in the text of such a file; `name` is what messages call it.
std::vector<std::int32_t> parse_seg(const std::string& text, const std::string& name, std::size_t faces);

/// Writes a segmentation, given by triangle or point, in that format, whole or not at all. A polygon has the number
/// that most of its area has. Throws InputError where the file cannot be written.
void write_seg(const std::filesystem::path& path, const Shape& shape, std::span<const std::int32_t> labels);

/// Writes the lines as they are, whole or not at all. Throws InputError where the file cannot be written.
void write_seg(const std::filesystem::path& path, std::span<const std::int32_t> labels);

}  // namespace shapegauge
