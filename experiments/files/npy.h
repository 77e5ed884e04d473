#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/io/scanner.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// The matrix of the given size whose entries lie one after the other in the bytes, row by row or column by column.
/// There are exactly rows * columns * sizeof(Number) bytes.
template <typename Number>
DistanceMatrix matrix_of_bytes(std::string_view bytes, Eigen::Index rows, Eigen::Index columns, std::endian order,
                               bool column_by_column) {
  DistanceMatrix matrix(column_by_column ? columns : rows, column_by_column ? rows : columns);
  ByteScanner scanner(bytes, order);
  for (Eigen::Index i = 0; i < matrix.size(); ++i) {
    Number value = 0;
    scanner.read(value);
    matrix.data()[i] = static_cast<double>(value);
  }
  if (column_by_column) matrix.transposeInPlace();
  return matrix;
}

/// Appends the number's bytes, little-endian.
template <typename Number>
void append_number(std::string& bytes, Number number) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(raw);
  bytes.append(raw.data(), raw.size());
}

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

/// Reads a square matrix from a NumPy `.npy` file: versions 1 to 3 of the format, float32 or float64, little- or
/// big-endian, C or Fortran order. Throws InputError: absent or unreadable file, another type or shape, a header that
/// is not understood, data of another length than the shape says.
DistanceMatrix read_npy(const std::filesystem::path& path);

/// The same for the bytes of a file; `source` stands in front of messages.
DistanceMatrix parse_npy(std::string_view bytes, const std::string& source);

/// Reads any matrix, square or not, in the same way. An array of one dimension is one column.
DistanceMatrix parse_npy_table(std::string_view bytes, const std::string& source);

/// Writes a matrix as `.npy`, version 1.0, little-endian float64, C order, as numpy.save does. Throws InputError where
/// the file cannot be written.
void write_npy(const std::filesystem::path& path, const DistanceMatrix& matrix);

/// Writes values as a one-dimensional array, in the same way.
void write_npy_vector(const std::filesystem::path& path, const Eigen::VectorXd& values);

}  // namespace shapegauge
