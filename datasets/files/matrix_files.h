// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/datasets/files/labelled_table.h"

namespace shapegauge {

/// Parses the Princeton Shape Benchmark's `.matrix` from the bytes of a file: N x N float32, little-endian, row by row,
/// no header. N follows from the number of bytes. `source` prefixes error messages. Throws InputError if the number of
/// bytes is not 4 N^2 (with a hint if it fits float64).
DistanceMatrix parse_psb_matrix(std::string_view bytes, const std::string& source);

/// Returns the number of rows of the matrix in a `.matrix` file of `bytes` bytes. Throws InputError as
/// parse_psb_matrix() does.
Eigen::Index psb_matrix_size(std::size_t bytes, const std::string& source);

/// Returns the extensions of the formats that read_matrix() reads, with their dots.
std::span<const std::string_view> matrix_extensions();

/// Reads a matrix of distances or features; the name's extension (any case) selects the format: `.matrix` (Princeton
/// Shape Benchmark), `.npy` or `.npz` (NumPy), `.mat` (MATLAB), `.csv` or `.tsv` (parse_csv_matrix(),
/// parse_csv_table()), `.txt` or `.dat` (parse_text_matrix()). All but `.mat` may be compressed, with an additional
/// `.gz`. Only `.csv` and `.tsv` may contain ids. `variable` names an array of an `.npz` or `.mat` file with several.
/// Where a square matrix is expected, a vector of n (n - 1) / 2 numbers in `.npy`, `.npz`, `.mat` or text is its upper
/// triangle row by row, as SciPy's pdist has it, and NaN on the diagonal is 0. Numbers may be infinite. Throws
/// InputError for an absent or unreadable file, an unknown extension, invalid contents, another shape and any other
/// NaN.
LabelledTable read_matrix(const std::filesystem::path& path, TableShape shape, const std::string& variable = "");

/// Writes a square matrix atomically: `.npy` (float64), or `.csv` with ids, which are numbers from 0 on if `ids` is
/// empty. Throws InputError for another extension, and if the file cannot be written.
void write_distance_matrix(const std::filesystem::path& path, const DistanceMatrix& distances,
                           const std::vector<std::string>& ids);

/// Row and column indices of a matrix entry.
struct MatrixPosition {
  Eigen::Index row = 0;     ///< index of the row, from 0
  Eigen::Index column = 0;  ///< index of the column, from 0
};

/// Sets NaN on the diagonal to 0 with TableShape::square. Throws InputError, with `path`, for any other NaN. `numbers`
/// is a block of a matrix; `first` is the row and column of its first number in the whole matrix.
void replace_or_refuse_nan(DistanceMatrix& numbers, const MatrixPosition& first, TableShape shape,
                           const std::filesystem::path& path);

/// Returns true if an array with these numbers of entries along its dimensions is a vector of n (n - 1) / 2 numbers for
/// some n: the vector may be the upper triangle of an n x n distance matrix (read_matrix()).
bool is_condensed_shape(std::span<const std::uint64_t> shape);

}  // namespace shapegauge
