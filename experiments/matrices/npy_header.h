#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace shapegauge {

/// What stands in front of the data of a NumPy `.npy` file (numpy.lib.format, versions 1.0 to 3.0).
struct NpyHeader {
  std::string type;  ///< as NumPy spells it: "<f8"
  bool column_by_column = false;
  std::vector<std::uint64_t> shape;
  std::size_t data_begin = 0;  ///< where the data begins, in bytes from the beginning of the file
};

/// Parses the header of the bytes of a `.npy` file. Throws InputError with `source`, the byte and what is wrong: no
/// `.npy` file, another version, cut off, a dictionary that is not understood.
NpyHeader parse_npy_header(std::string_view bytes, const std::string& source);

/// The header (version 1.0) of a matrix of little-endian float64, row by row.
std::string npy_header_of_matrix(std::size_t rows, std::size_t columns);

/// The header (version 1.0) of so many little-endian float64 in one dimension.
std::string npy_header_of_vector(std::size_t size);

}  // namespace shapegauge
