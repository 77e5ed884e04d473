#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace shapegauge {

/// Reads a segmentation in the Princeton Segmentation Benchmark's format: for each face, in the mesh's order, a line
/// with the number of its segment, 0 or more. Throws InputError where the file cannot be read, has another number of
/// lines than the mesh has `faces`, or holds what is no such number.
std::vector<std::int32_t> read_seg(const std::filesystem::path& path, std::size_t faces);

/// The same for the text of such a file; `name` is what messages call it.
std::vector<std::int32_t> parse_seg(const std::string& text, const std::string& name, std::size_t faces);

/// Writes a segmentation in that format, whole or not at all. Throws InputError where the file cannot be written.
void write_seg(const std::filesystem::path& path, std::span<const std::int32_t> labels);

}  // namespace shapegauge
