// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/datasets/files/labelled_table.h"

namespace shapegauge {

/// Header of a NumPy `.npy` file (numpy.lib.format, versions 1.0 to 3.0).
struct NpyHeader {
  std::string type;                  ///< type of the numbers in NumPy's notation, such as "<f8"
  bool column_by_column = false;     ///< true if data are stored column by column (Fortran order)
  std::vector<std::uint64_t> shape;  ///< number of entries along each dimension
  std::size_t data_begin = 0;        ///< offset of the data from the beginning of the file, in bytes
};

/// Binary number format: size of a number, and a function that decodes numbers. The function throws InputError as
/// exact_number() does.
struct NumberFormat {
  std::size_t bytes = 0;  ///< size of one number in bytes
  /// Decodes the first `count` numbers of `bytes` and writes them to `numbers`.
  void (*decode)(const char* bytes, std::size_t count, double* numbers) = nullptr;
};

/// Returns the format of little-endian float32.
NumberFormat float32_format();

/// Layout of a matrix in a `.npy` file: its size, number format and order, and where the data begin.
struct NpyTable {
  Eigen::Index rows = 0;          ///< number of rows of the matrix
  Eigen::Index columns = 0;       ///< number of columns of the matrix; 1 for a one-dimensional array
  NumberFormat numbers;           ///< format of the matrix entries
  bool column_by_column = false;  ///< true if data are stored column by column (Fortran order)
  std::size_t data_begin = 0;     ///< offset of the data from the beginning of the file, in bytes
};

/// Parses the header of a `.npy` file. Throws InputError, with `source` and the byte, for another format or version, a
/// truncated header, and an invalid dictionary.
NpyHeader parse_npy_header(std::string_view bytes, const std::string& source);

/// Formats the `.npy` header (version 1.0) of a row-major matrix of little-endian float64.
std::string npy_header_of_matrix(std::size_t rows, std::size_t columns);

/// Formats the `.npy` header (version 1.0) of a one-dimensional array of `size` numbers, little-endian float64.
std::string npy_header_of_vector(std::size_t size);

/// Encodes numbers as little-endian float64, the data that follow the header of a `.npy` file.
std::string npy_numbers(std::span<const double> numbers);

/// Validates the header of a numeric array against the size of its file in bytes. `beginning` is the beginning of the
/// file and must contain the header. A one-dimensional array is one column. Throws InputError for an invalid header, an
/// unsupported type, a shape that `shape` does not accept, and data of the wrong length.
NpyTable parse_npy_table_header(std::string_view beginning, std::size_t file_size, TableShape shape,
                                const std::string& source);

/// Reads a matrix from the bytes of a NumPy `.npy` file: versions 1 to 3 of the format, floating-point numbers
/// of 16, 32 or 64 bits, integers or booleans, little- or big-endian, C or Fortran order. Throws InputError as
/// parse_npy_table_header() does.
DistanceMatrix parse_npy(std::string_view bytes, const std::string& source, TableShape shape);

/// Reads an array of strings, one-dimensional or with one row or column, from the bytes of a `.npy` file: NumPy's types
/// `U`, converted to UTF-8, and `S`. Nothing for an array of another type. Throws InputError as
/// parse_npy_table_header() does.
std::optional<std::vector<std::string>> parse_npy_strings(std::string_view bytes, const std::string& source);

/// Writes a matrix as `.npy`, version 1.0, little-endian float64, C order, as numpy.save does. Throws InputError if the
/// file cannot be written.
void write_npy(const std::filesystem::path& path, const DistanceMatrix& matrix);

/// Writes values as a one-dimensional `.npy` array.
void write_npy_vector(const std::filesystem::path& path, const Eigen::VectorXd& values);

}  // namespace shapegauge
