#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "shapegauge/datasets/files/text_matrices.h"
#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// Reads the Princeton Shape Benchmark's `.matrix`: N x N float32, little-endian, row by row, no header. N follows from
/// the size of the file. Throws InputError: absent, empty or unreadable file, a size that is not 4 N^2 bytes (with a
/// hint where it looks like float64).
DistanceMatrix read_psb_matrix(const std::filesystem::path& path);

/// The same for the bytes of a file; `source` stands in front of messages.
DistanceMatrix parse_psb_matrix(std::string_view bytes, const std::string& source);

/// N of a `.matrix` file of so many bytes. Throws InputError as above.
Eigen::Index psb_matrix_size(std::size_t bytes, const std::string& source);

/// Reads a square distance matrix in the format that the name's extension tells (any case): `.matrix` (Princeton Shape
/// Benchmark), `.npy` or `.npz` (NumPy), `.mat` (MATLAB), `.csv`, `.txt` or `.dat` (numbers between white space), each
/// but `.mat` also compressed, with `.gz` behind. Only CSV carries ids. Distances may be infinite. Throws InputError:
/// absent or unreadable file, another extension, anything that the reader of the format refuses, a distance that is
/// NaN.
LabelledDistances read_distance_matrix(const std::filesystem::path& path);

/// Writes a square matrix, whole or not at all: `.npy` (float64), or `.csv` with ids, which are the models' numbers
/// from 0 on where they are not known. Throws InputError for another extension, and where it cannot be written.
void write_distance_matrix(const std::filesystem::path& path, const LabelledDistances& matrix);

/// Reads any table of numbers in the same way: distances between two sets of models, or features. Throws InputError as
/// read_distance_matrix, but for the shape.
LabelledTable read_number_table(const std::filesystem::path& path);

/// The place of a number in a matrix.
struct MatrixPlace {
  Eigen::Index row = 0;
  Eigen::Index column = 0;
};

/// Throws InputError where one of the numbers is NaN. `first`: the place in the whole matrix of the first of them.
/// `what`: what messages call a number.
void refuse_nan(const DistanceMatrix& numbers, const MatrixPlace& first, std::string_view what,
                const std::filesystem::path& path);

}  // namespace shapegauge
