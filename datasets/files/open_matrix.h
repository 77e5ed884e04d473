// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "shapegauge/datasets/files/matrix_files.h"

namespace shapegauge {

/// Rectangular block of a matrix: its first row and column, and its numbers of rows and columns.
struct MatrixBlock {
  Eigen::Index first_row = 0;     ///< index, in the matrix, of the first row of the block
  Eigen::Index rows = 0;          ///< number of rows of the block
  Eigen::Index first_column = 0;  ///< index, in the matrix, of the first column of the block
  Eigen::Index columns = 0;       ///< number of columns of the block
};

/// Matrix that is read in blocks and need not be in memory as a whole. Blocks are read in parallel and are the same for
/// any number of threads.
struct OpenMatrix {
  Eigen::Index rows = 0;                                   ///< number of rows of the matrix
  Eigen::Index columns = 0;                                ///< number of columns of the matrix
  std::function<DistanceMatrix(const MatrixBlock&)> read;  ///< returns a block of the matrix
  std::vector<std::string> row_ids{};                      ///< ids of the models of the rows; empty if unknown
  std::vector<std::string> column_ids{};  ///< ids of the models or features of the columns; empty if unknown
};

/// Opens a matrix with the arguments and formats of read_matrix(). For `.matrix` files and `.npy` files in C order,
/// only the requested blocks are in memory, and a NaN is an error of its block; other files are read as a whole.
OpenMatrix open_matrix(const std::filesystem::path& path, TableShape shape, const std::string& variable = "");

/// Makes an OpenMatrix of a table in memory.
OpenMatrix open_matrix(LabelledTable table);

/// Reads the whole matrix into memory.
DistanceMatrix whole_matrix(const OpenMatrix& matrix);

}  // namespace shapegauge
