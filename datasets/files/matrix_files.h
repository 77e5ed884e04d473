#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "shapegauge/datasets/files/text_matrices.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// Reads the Princeton Shape Benchmark's `.matrix`: N x N float32, little-endian, row by row, no header. N follows from
/// the size of the file. Throws InputError for an absent, empty or unreadable file and a size that is not 4 N^2 bytes
/// (with a hint if it is that of float64).
DistanceMatrix read_psb_matrix(const std::filesystem::path& path);

/// Reads a `.matrix` from the bytes of a file; `source` prefixes error messages.
DistanceMatrix parse_psb_matrix(std::string_view bytes, const std::string& source);

/// Returns N of a `.matrix` file of that many bytes. Throws InputError as read_psb_matrix() does.
Eigen::Index psb_matrix_size(std::size_t bytes, const std::string& source);

/// Reads a square distance matrix; the name's extension (any case) selects the format: `.matrix` (Princeton Shape
/// Benchmark), `.npy` or `.npz` (NumPy), `.mat` (MATLAB), `.csv`, `.txt` or `.dat` (numbers separated by white space).
/// All but `.mat` may be compressed, with an additional `.gz`. Only CSV contains ids. Distances may be infinite. Throws
/// InputError for an absent or unreadable file, an unknown extension, invalid contents and a NaN distance.
LabelledDistances read_distance_matrix(const std::filesystem::path& path);

/// Writes a square matrix atomically: `.npy` (float64), or `.csv` with ids, which are numbers from 0 on if unknown.
/// Throws InputError for another extension, and if the file cannot be written.
void write_distance_matrix(const std::filesystem::path& path, const LabelledDistances& matrix);

/// Reads any table of numbers: distances between two sets of models, or features. Throws InputError as
/// read_distance_matrix() does, except for the shape.
LabelledTable read_number_table(const std::filesystem::path& path);

/// Row and column of a matrix entry.
struct MatrixPlace {
  Eigen::Index row = 0;
  Eigen::Index column = 0;
};

/// Throws InputError if a number is NaN. `first` is the position of the first number in the whole matrix; `what` is the
/// noun for a number in messages.
void refuse_nan(const DistanceMatrix& numbers, const MatrixPlace& first, std::string_view what,
                const std::filesystem::path& path);

}  // namespace shapegauge
