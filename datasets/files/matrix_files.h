#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/retrieval/distance_matrix.h"

namespace shapegauge {

/// A distance matrix and the models that its rows and columns stand for.
struct LabelledDistances {
  DistanceMatrix distances;
  std::vector<std::string> ids;  ///< of row and column i; empty where they are not known
};

/// A table of numbers: distances from the rows' models to the columns', or a row of features for each model.
struct LabelledTable {
  DistanceMatrix numbers;
  std::vector<std::string> row_ids;     ///< empty where they are not known
  std::vector<std::string> column_ids;  ///< so too
};

/// What a reader takes: the square matrix of a distance, or any table of numbers.
enum class TableShape { square, any };

/// Reads a square matrix of numbers separated by commas, semicolons or tabs (number_separator()). With ids: a header
/// row (a first cell that is not a number, then the ids of the columns) and an id in front of each row, the same ids in
/// the same order. Where the very first cell is a number the file has no ids. Cells may be quoted. Throws InputError:
/// absent or unreadable file, something that is not a number, a row of another length, not as many rows as columns, an
/// id that is empty or occurs twice, ids of rows and columns that differ.
LabelledDistances read_csv_matrix(const std::filesystem::path& path);

/// The same for the text of a file; `source` stands in front of messages.
LabelledDistances parse_csv_matrix(std::string_view text, const std::string& source);

/// Reads any table of numbers, separated as above, with rows of equal length, with or without ids. The first row is a
/// header where its first cell is no number, unless all its other cells are numbers and that cell is neither empty nor
/// "id". The first column holds the ids of the rows where the header begins with an empty cell or "id", or where the
/// first cell of the first row of numbers is no number. Throws InputError as read_csv_matrix.
LabelledTable parse_csv_table(std::string_view text, const std::string& source);

/// Reads the Princeton Shape Benchmark's `.matrix`: N x N float32, little-endian, row by row, no header. N follows from
/// the size of the file. Throws InputError: absent, empty or unreadable file, a size that is not 4 N^2 bytes (with a
/// hint where it looks like float64).
DistanceMatrix read_psb_matrix(const std::filesystem::path& path);

/// The same for the bytes of a file; `source` stands in front of messages.
DistanceMatrix parse_psb_matrix(std::string_view bytes, const std::string& source);

/// Reads a square matrix of numbers between blanks, one row a line, as numpy.savetxt writes it; where its first row has
/// semicolons or, failing that, commas, those separate the numbers. Empty lines and lines that begin with `#` are
/// passed over; `inf` is a number. Throws InputError: absent or unreadable file, something that is not a number, a row
/// of another length, not as many rows as columns.
DistanceMatrix read_text_matrix(const std::filesystem::path& path);

/// The same for the text of a file; `source` stands in front of messages. With TableShape::any the rows need only be of
/// equal length.
DistanceMatrix parse_text_matrix(std::string_view text, const std::string& source,
                                 TableShape shape = TableShape::square);

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
