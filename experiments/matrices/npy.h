#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <string_view>

#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

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
