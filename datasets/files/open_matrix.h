#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "shapegauge/datasets/files/matrix_files.h"

namespace shapegauge {

/// A rectangle of a matrix.
struct MatrixBlock {
  Eigen::Index first_row = 0;
  Eigen::Index rows = 0;
  Eigen::Index first_column = 0;
  Eigen::Index columns = 0;
};

/// A matrix that is read a block at a time, so that all of it need never be in memory. Blocks are read in parallel and
/// are the same for any number of threads.
struct OpenMatrix {
  Eigen::Index rows = 0;
  Eigen::Index columns = 0;
  std::function<DistanceMatrix(const MatrixBlock&)> read;
  std::vector<std::string> row_ids{};     ///< empty where they are not known
  std::vector<std::string> column_ids{};  ///< so too
};

/// Opens a matrix as read_distance_matrix or read_number_table reads it. Of `.matrix` files and of `.npy` files in C
/// order only the wanted blocks are in memory, and NaN is an error of the block that has it; others are read as a
/// whole.
OpenMatrix open_matrix(const std::filesystem::path& path, TableShape shape);

/// A matrix in memory, to be read in the same way.
OpenMatrix open_matrix(LabelledTable table);

/// All of it at once.
DistanceMatrix whole_matrix(const OpenMatrix& matrix);

}  // namespace shapegauge
