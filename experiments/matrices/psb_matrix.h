#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// Reads the Princeton Shape Benchmark's `.matrix`: N x N float32, little-endian, row by row, no header. N follows from
/// the size of the file. Throws InputError: absent, empty or unreadable file, a size that is not 4 N^2 bytes (with a
/// hint where it looks like float64).
DistanceMatrix read_psb_matrix(const std::filesystem::path& path);

/// The same for the bytes of a file; `source` stands in front of messages.
DistanceMatrix parse_psb_matrix(std::string_view bytes, const std::string& source);

/// Writes that format; distances are rounded to float32. Throws InputError where the file cannot be written or a finite
/// distance is beyond float32.
void write_psb_matrix(const std::filesystem::path& path, const DistanceMatrix& matrix);

}  // namespace shapegauge
