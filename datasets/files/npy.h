#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

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

/// How numbers lie in a file: their size in bytes, and what makes `count` of them doubles.
struct NumberFormat {
  std::size_t bytes = 0;
  void (*decode)(const char* bytes, std::size_t count, double* numbers) = nullptr;
};

/// Little-endian float32.
NumberFormat float32_format();

/// A matrix in a file: its size, and how and where its numbers lie.
struct NpyTable {
  Eigen::Index rows = 0;
  Eigen::Index columns = 0;
  NumberFormat numbers;
  bool column_by_column = false;
  std::size_t data_begin = 0;
};

/// Parses the header of the bytes of a `.npy` file. Throws InputError with `source`, the byte and what is wrong: no
/// `.npy` file, another version, cut off, a dictionary that is not understood.
NpyHeader parse_npy_header(std::string_view bytes, const std::string& source);

/// The header (version 1.0) of a matrix of little-endian float64, row by row.
std::string npy_header_of_matrix(std::size_t rows, std::size_t columns);

/// The header (version 1.0) of so many little-endian float64 in one dimension.
std::string npy_header_of_vector(std::size_t size);

/// The numbers as little-endian float64, as they follow the header.
std::string npy_numbers(std::span<const double> numbers);

/// Checks the header of an array of numbers against the size of its file. `beginning` holds at least the header. An
/// array of one dimension is one column. Throws InputError: another type or shape, a header that is not understood,
/// data of another length than the shape says; where it must be `square`, any other matrix.
NpyTable parse_npy_table_header(std::string_view beginning, std::size_t file_size, bool square,
                                const std::string& source);

/// Reads a square matrix from the bytes of a NumPy `.npy` file: versions 1 to 3 of the format, floating-point
/// numbers of 16, 32 or 64 bits, integers or booleans, little- or big-endian, C or Fortran order. Throws InputError as
/// parse_npy_table_header.
DistanceMatrix parse_npy(std::string_view bytes, const std::string& source);

/// Reads any matrix, square or not, in the same way.
DistanceMatrix parse_npy_table(std::string_view bytes, const std::string& source);

/// Reads an array of strings, of one dimension or of one row or column, from the bytes of a `.npy` file: NumPy's types
/// `U`, which becomes UTF-8, and `S`. Nothing where the array is of another type. Throws InputError as
/// parse_npy_table_header.
std::optional<std::vector<std::string>> parse_npy_strings(std::string_view bytes, const std::string& source);

/// Writes a matrix as `.npy`, version 1.0, little-endian float64, C order, as numpy.save does. Throws InputError where
/// the file cannot be written.
void write_npy(const std::filesystem::path& path, const DistanceMatrix& matrix);

/// Writes values as a one-dimensional array, in the same way.
void write_npy_vector(const std::filesystem::path& path, const Eigen::VectorXd& values);

}  // namespace shapegauge
